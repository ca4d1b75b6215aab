//! The Gene Pool.

use katydid_definition::archive::{Chunk, Item};
use katydid_definition::document::{Object, Special, ids};

use super::list::MOST_ITEMS;
use super::parts::number;
use super::{FACE, Row, decimal, finite, part, unfit};
use crate::Refusal;
use crate::protocol::Control;

pub(super) const GENE_POOL: Row = Row {
    components: &[ids::GENE_POOL],
    is_set_by_hand: true,
    grows: true,
    begin: |container| {
        let mut pool = Chunk::new("GeneData");
        pool.set("Count", 10);
        pool.set("Decimals", 2);
        pool.set("Maximum", 100.0);
        pool.set("Minimum", 0.0);
        for k in 0..10 {
            pool.set_at("Value", k, decimal(50.0, 2));
        }
        container.set_child(pool);
    },
    view: |_, special| {
        let Special::GenePool(pool) = special else { return None };
        Some(Control::Genes { values: pool.values, decimals: pool.decimals, min: pool.min, max: pool.max })
    },
    shape: |object, control| {
        let Control::Genes { values, decimals, min, max } = control else { return Ok(false) };
        shape(object, values, *decimals, *min, *max)
    },
    size: |special, _| {
        let Special::GenePool(pool) = special else { return None };
        let rows = u16::try_from(pool.values.len().clamp(1, 20)).map_or(1.0, f32::from);
        Some([146.0, rows * 20.0 + 32.0])
    },
    ..FACE
};

fn shape(object: &mut Object, values: &[f64], decimals: i32, min: f64, max: f64) -> Result<bool, Refusal> {
    finite(values)?;
    finite(&[min, max])?;
    if values.len() > MOST_ITEMS || min > max {
        return Err(unfit(object, "a pool has at most ten thousand numbers between its limits"));
    }
    let places = u32::try_from(decimals.clamp(0, 12)).unwrap_or(2);
    let pool = part(object, "GeneData")?;
    pool.remove("Value");
    for (k, x) in (0..).zip(values) {
        pool.items.push(Item::indexed("Value", k, decimal(x.clamp(min, max), places)));
    }
    pool.set("Count", i32::try_from(values.len()).unwrap_or(i32::MAX));
    pool.set("Decimals", decimals.clamp(0, 12));
    number(pool, "Minimum", min);
    number(pool, "Maximum", max);
    Ok(true)
}
