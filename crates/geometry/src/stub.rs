#![allow(missing_docs)]
use crate::*;
#[derive(Debug,Clone,PartialEq)] pub struct Matrix;
impl Matrix{ pub fn identity(_:usize)->Self{Self} pub fn from_rows(_:&[Vec<f64>])->Result<Self>{Ok(Self)} pub fn rows(&self)->usize{0} pub fn columns(&self)->usize{0} pub fn add(&self,_:&Self)->Result<Self>{Ok(Self)} pub fn scaled(&self,_:f64)->Self{Self} pub fn multiply(&self,_:&Self)->Result<Self>{Ok(Self)}}
impl Mesh{pub fn from_box(_:&Box3,_:usize,_:usize,_:usize)->Result<Self>{Err(Error::Unsupported(""))}}
