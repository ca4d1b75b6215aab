//! `NurbsSurface.Create`, and the surface's lists: control points and knots, which scripts set one by one.
//!
//! A list of knots is that of one direction; it says which before the other arguments.

use katydid_geometry::{Point2, Point3, Surface};

use super::beyond;
use crate::geometry::answer::Outcome;
use crate::geometry::argument::Count;
use crate::geometry::choice::Along;
use crate::geometry::table::Endpoints;
use crate::shape::{Geometry, Record, Shape};
use crate::unfinished_surface::UnfinishedSurface;
use crate::wire::Read;
use crate::{Fault, Value};

type Index = Count<0, 10_000_000>;
type Order = Count<2, 12>;
type Points = Count<2, 100_000>;

pub(super) fn enter(table: &mut Endpoints) {
    makers(table);
    points(table);
    weights(table);
    knots(table);
}

fn makers(table: &mut Endpoints) {
    table.member("NurbsSurface.new other", |s: Surface| match s {
        Surface::Nurbs(_) => Ok(s),
        _ => Err(Fault::bad_request("other is no NurbsSurface")),
    });
    table.member(
        "NurbsSurface.Create dimension isRational order0 order1 controlPointCount0 controlPointCount1",
        |dimension: Count<1, 4>, rational: bool, u: Order, v: Order, nu: Points, nv: Points| {
            if dimension.0 != 3 {
                return Err(Fault::not_supported(format!("a NurbsSurface of {} dimensions", dimension.0)));
            }
            let degrees = [u.0 - 1, v.0 - 1];
            UnfinishedSurface::new(degrees, [nu.0, nv.0], rational).map(UnfinishedSurface::shape)
        },
    );
    table.member("NurbsSurface.CopyFrom &this other", |_: Written, other: Written| Ok(((), other.0.shape())));
    table.member("NurbsSurface.MakeNonRational &this", |Written(mut s): Written| {
        let equal = |weights: &Vec<f64>| weights.windows(2).all(|pair| pair.first() == pair.last());
        let can = s.weights.as_ref().is_none_or(equal);
        if can {
            s.weights = None;
        }
        Ok((can, s.shape()))
    });
}

fn points(table: &mut Endpoints) {
    table.member("NurbsSurfacePointList.get_CountU this", |s: Written| Ok(s.0.counts[0]));
    table.member("NurbsSurfacePointList.get_CountV this", |s: Written| Ok(s.0.counts[1]));
    table.member("NurbsSurfacePointList.ToArray this", |s: Written| {
        let all = 0..s.0.points.len();
        Ok(all.filter_map(|place| control_point(&s.0, place)).collect::<Vec<Record>>())
    });
    table.member("NurbsSurfacePointList.GetControlPoint this u v", |s: Written, i: Index, j: Index| {
        control_point(&s.0, s.at(i, j)?).ok_or_else(|| s.beyond(i, j))
    });
    table.member("NurbsSurfacePointList.GetPoint this u v", |s: Written, i: Index, j: Index| {
        let point = s.at(i, j).ok().and_then(|place| s.0.points.get(place).copied());
        Ok((point.is_some(), point))
    });
    table.member("NurbsSurfacePointList.GetGrevillePoint this u v", |s: Written, i: Index, j: Index| {
        s.at(i, j)?;
        let mean = |k: usize, from: usize| {
            let degree = s.0.degrees[k];
            let own = s.0.knots[k].get(from..from + degree).unwrap_or_default();
            #[expect(clippy::cast_precision_loss, reason = "a degree is small")]
            let count = degree as f64;
            own.iter().sum::<f64>() / count
        };
        Ok(Point2::new(mean(0, i.0), mean(1, j.0)))
    });
    table.member(
        "NurbsSurfacePointList.SetPoint &this u v point",
        |s: Written, i: Index, j: Index, to: Point3| s.with_point(i, j, to, None),
    );
    table.member(
        "NurbsSurfacePointList.SetPoint &this u v point weight",
        |s: Written, i: Index, j: Index, to: Point3, weight: f64| s.with_point(i, j, to, Some(weight)),
    );
    table.member(
        "NurbsSurfacePointList.SetPoint &this u v x y z",
        |s: Written, i: Index, j: Index, x: f64, y: f64, z: f64| {
            s.with_point(i, j, Point3::new(x, y, z), None)
        },
    );
    table.member(
        "NurbsSurfacePointList.SetPoint &this u v x y z weight",
        |s: Written, i: Index, j: Index, x: f64, y: f64, z: f64, weight: f64| {
            s.with_point(i, j, Point3::new(x, y, z), Some(weight))
        },
    );
}

fn weights(table: &mut Endpoints) {
    table.member("NurbsSurfacePointList.GetWeight this u v", |s: Written, i: Index, j: Index| {
        s.0.weight(s.at(i, j)?).ok_or_else(|| s.beyond(i, j))
    });
    table.member(
        "NurbsSurfacePointList.SetWeight &this u v weight",
        |s: Written, i: Index, j: Index, weight: f64| {
            let place = s.at(i, j)?;
            let Written(mut s) = s;
            s.set_weight(place, sound_weight(weight)?);
            Ok((true, s.shape()))
        },
    );
}

fn knots(table: &mut Endpoints) {
    table.member("NurbsSurface.get_KnotsU this", |s: Written| Ok(s.0.knots[0].clone()));
    table.member("NurbsSurface.get_KnotsV this", |s: Written| Ok(s.0.knots[1].clone()));
    table.member("NurbsSurfaceKnotList.ToArray this direction", |s: Written, along: Along| {
        Ok(s.0.knots[along.0.index()].clone())
    });
    table.member(
        "NurbsSurfaceKnotList.get_Item this direction index",
        |s: Written, along: Along, i: Index| {
            let own = &s.0.knots[along.0.index()];
            own.get(i.0).copied().ok_or_else(|| beyond(i.0, own.len()))
        },
    );
    table.member(
        "NurbsSurfaceKnotList.set_Item &this direction index value",
        |Written(mut s): Written, along: Along, i: Index, knot: f64| {
            let own = &mut s.knots[along.0.index()];
            let count = own.len();
            *own.get_mut(i.0).ok_or_else(|| beyond(i.0, count))? = knot;
            Ok(((), s.shape()))
        },
    );
    table.member(
        "NurbsSurfaceKnotList.CreateUniformKnots &this direction knotSpacing",
        |s: Written, along: Along, spacing: f64| uniform(s, along.0.index(), spacing, true),
    );
    table.member(
        "NurbsSurfaceKnotList.CreatePeriodicKnots &this direction knotSpacing",
        |s: Written, along: Along, spacing: f64| uniform(s, along.0.index(), spacing, false),
    );
}

fn uniform(Written(mut s): Written, k: usize, spacing: f64, clamped: bool) -> Outcome<(bool, Shape)> {
    super::nurbs_lists::space(&mut s.knots[k], s.degrees[k], s.counts[k], spacing, clamped)?;
    Ok((true, s.shape()))
}

fn sound_weight(weight: f64) -> Outcome<f64> {
    if weight.is_finite() && weight > 0.0 {
        return Ok(weight);
    }
    Err(Fault::bad_request(format!("weight is {weight}, which must be greater than 0")))
}

/// A NURBS surface, finished or not, by its numbers.
struct Written(UnfinishedSurface);

impl Written {
    /// The place of a control point in the list.
    fn at(&self, i: Index, j: Index) -> Outcome<usize> {
        self.0.place(i.0, j.0).ok_or_else(|| self.beyond(i, j))
    }

    fn beyond(&self, i: Index, j: Index) -> Fault {
        let [nu, nv] = self.0.counts;
        Fault::bad_request(format!("u, v are {}, {}, of {nu} by {nv}", i.0, j.0))
    }

    fn with_point(self, i: Index, j: Index, to: Point3, weight: Option<f64>) -> Outcome<(bool, Shape)> {
        let place = self.at(i, j)?;
        let Self(mut s) = self;
        if let Some(own) = s.points.get_mut(place) {
            *own = to;
        }
        if let Some(weight) = weight {
            s.set_weight(place, sound_weight(weight)?);
        }
        Ok((true, s.shape()))
    }
}

impl Read for Written {
    fn read(json: &serde_json::Value) -> Result<Self, Fault> {
        Ok(Self(UnfinishedSurface::of(&Surface::read(json)?.to_nurbs()?)))
    }

    fn of_value(value: &Value) -> Result<Self, Fault> {
        if let Value::Geometry(Geometry { shape: Shape::UnfinishedSurface(own), .. }) = value {
            return Ok(Self((**own).clone()));
        }
        Ok(Self(UnfinishedSurface::of(&Surface::of_value(value)?.to_nurbs()?)))
    }

    fn type_name() -> String {
        "NurbsSurface".into()
    }
}

fn control_point(s: &UnfinishedSurface, place: usize) -> Option<Record> {
    Some(super::nurbs_lists::control_point_record(*s.points.get(place)?, s.weight(place)?))
}
