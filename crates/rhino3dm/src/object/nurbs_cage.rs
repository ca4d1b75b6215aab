//! Class NurbsCage (section 8): a NURBS volume.

use crate::chunk::{Reader, Writer};
use crate::{Error, Result};

/// A NURBS volume: a box of control points with knots in three directions.
#[derive(Debug, Clone, PartialEq)]
pub struct NurbsCage {
    dimension: usize,
    rational: bool,
    orders: [usize; 3],
    counts: [usize; 3],
    knots: [Vec<f64>; 3],
    numbers: Vec<f64>,
}

const WHAT: &str = "NURBS cage";
/// The dimensions, orders and counts that the official reader takes.
const MOST_DIMENSIONS: usize = 10_000;
const MOST_ORDERS: usize = 10_000;
const MOST_COUNTS: usize = 100_000;

impl NurbsCage {
    /// A volume of `counts` control points of `dimension` coordinates each, homogeneous with the weight last when
    /// rational, the third direction running fastest. Each knot vector has order + count − 2 knots.
    ///
    /// # Errors
    /// An order below 2 or above its count, knots that do not increase, or numbers that are too few, too many or
    /// not finite.
    pub fn new(
        dimension: usize,
        rational: bool,
        orders: [usize; 3],
        knots: [Vec<f64>; 3],
        counts: [usize; 3],
        numbers: Vec<f64>,
    ) -> std::result::Result<Self, String> {
        check_sizes(dimension, orders, counts)?;
        for ((order, count), knots) in orders.iter().zip(counts).zip(&knots) {
            if knots.len() != order + count - 2 {
                return Err(format!(
                    "order {order} and {count} points ask for other than {} knots",
                    knots.len()
                ));
            }
            if !knots.is_sorted() {
                return Err("its knots do not increase".into());
            }
        }
        let size = numbers_in(dimension, rational, counts).ok_or("it has too many control points")?;
        if numbers.len() != size {
            return Err(format!("{} numbers are given for control points of {size}", numbers.len()));
        }
        if !numbers.iter().chain(knots.iter().flatten()).all(|x| x.is_finite()) {
            return Err("a number is not finite".into());
        }
        Ok(Self { dimension, rational, orders, counts, knots, numbers })
    }

    /// Coordinates of a control point, the weight not counted.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// Whether the control points have weights.
    pub fn is_rational(&self) -> bool {
        self.rational
    }

    /// The orders (degree + 1) in the three directions.
    pub fn orders(&self) -> [usize; 3] {
        self.orders
    }

    /// How many control points there are in each direction.
    pub fn counts(&self) -> [usize; 3] {
        self.counts
    }

    /// The knots in the three directions.
    pub fn knots(&self) -> &[Vec<f64>; 3] {
        &self.knots
    }

    /// The control points one after another, the third direction running fastest; homogeneous when rational.
    pub fn numbers(&self) -> &[f64] {
        &self.numbers
    }
}

fn check_sizes(dimension: usize, orders: [usize; 3], counts: [usize; 3]) -> std::result::Result<(), String> {
    if !(1..=MOST_DIMENSIONS).contains(&dimension) {
        return Err(format!("{dimension} is no dimension"));
    }
    for (order, count) in orders.into_iter().zip(counts) {
        if !(2..=MOST_ORDERS).contains(&order) || !(order..=MOST_COUNTS).contains(&count) {
            return Err(format!("order {order} does not go with {count} control points"));
        }
    }
    Ok(())
}

/// How many numbers the control points have together; nothing when they cannot be counted.
fn numbers_in(dimension: usize, rational: bool, counts: [usize; 3]) -> Option<usize> {
    counts.into_iter().try_fold(dimension + usize::from(rational), usize::checked_mul)
}

pub(super) fn read(body: &mut Reader<'_>) -> Result<NurbsCage> {
    let offset = body.offset();
    let malformed = |why: String| Error::malformed(offset, WHAT, why);
    let (mut body, _) = body.versioned_1(WHAT)?;
    let mut size = || -> Result<usize> {
        let number = body.i32(WHAT)?;
        usize::try_from(number).map_err(|_| malformed(format!("{number} is no size")))
    };
    let dimension = size()?;
    let rational = size()? == 1;
    let orders = [size()?, size()?, size()?];
    let counts = [size()?, size()?, size()?];
    check_sizes(dimension, orders, counts).map_err(malformed)?;
    let mut knots = [const { Vec::new() }; 3];
    for ((knots, order), count) in knots.iter_mut().zip(orders).zip(counts) {
        *knots = body.doubles_of(order + count - 2, WHAT)?;
    }
    let size = numbers_in(dimension, rational, counts)
        .ok_or_else(|| malformed("it has too many control points".into()))?;
    let numbers = body.doubles_of(size, WHAT)?;
    body.finish();
    NurbsCage::new(dimension, rational, orders, knots, counts, numbers).map_err(malformed)
}

pub(super) fn write(cage: &NurbsCage, w: &mut Writer) -> Result<()> {
    w.versioned(1, 0, |w| {
        w.count(cage.dimension, "dimensions")?;
        w.i32(i32::from(cage.rational));
        for size in cage.orders.into_iter().chain(cage.counts) {
            w.count(size, "control points")?;
        }
        cage.knots.iter().flatten().chain(&cage.numbers).for_each(|x| w.f64(*x));
        Ok(())
    })
}
