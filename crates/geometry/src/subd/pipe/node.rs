//! What a node is, and how far from it its rings lie.

use katydid_elementary::Elementary;

use super::cube::{Cube, fitted};
use super::network::MultiPipeNetwork;
use super::{CAGE, MultiPipe};
use crate::{Error, Result, Vector3};

/// How much farther rings are from a node than where they would touch.
const APART: f64 = 1.05;
/// The most of a strut that the joint at one of its ends may take.
const SHARE: f64 = 0.45;
/// Struts that meet at a smaller angle, in radians, run along each other.
const NARROWEST: f64 = 0.01;

/// What stands at a node.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Node {
    /// A single strut ends.
    End {
        /// The radius of its ring.
        reach: f64,
    },
    /// Two struts pass into each other through a ring in the plane between them.
    Through {
        /// The radius of the ring, at right angles to a strut.
        reach: f64,
    },
    /// A hull joins rings at a distance.
    Joint {
        /// The radius of the rings.
        reach: f64,
        /// How far they are from the node.
        distance: f64,
    },
    /// A cube, with a strut on some of its sides.
    Cube(Box<Cube>),
}

/// The kinds of all nodes.
pub(super) fn nodes(options: &MultiPipe, network: &MultiPipeNetwork) -> Result<Vec<Node>> {
    let radii = network.radii(options);
    let around = network.around();
    around
        .iter()
        .zip(radii)
        .enumerate()
        .map(|(node, (struts, r))| kind(options, network, (node, struts), r))
        .collect()
}

fn kind(
    options: &MultiPipe,
    network: &MultiPipeNetwork,
    (node, struts): (usize, &[(usize, usize)]),
    radius: f64,
) -> Result<Node> {
    let reach = CAGE * radius;
    if struts.len() < 2 {
        return Ok(Node::End { reach });
    }
    let directions: Vec<Vector3> = struts.iter().map(|s| network.direction(*s)).collect();
    let narrowest = narrowest(&directions);
    if struts.len() == 2 && narrowest >= std::f64::consts::FRAC_PI_2 {
        return Ok(Node::Through { reach });
    }
    if !(narrowest >= NARROWEST) {
        let p = network.nodes[node];
        return Err(Error::Invalid {
            what: "network",
            why: format!("two struts run along each other from ({}, {}, {})", p.x, p.y, p.z),
        });
    }
    let shortest = struts.iter().map(|(s, _)| network.length(*s)).fold(f64::INFINITY, f64::min);
    let farthest = SHARE * shortest;
    if options.cube_fit > 0.0
        && let Some(axes) = fitted(&directions, options.cube_fit)
    {
        let half = (reach * std::f64::consts::FRAC_1_SQRT_2).min(farthest);
        return Ok(Node::Cube(Box::new(Cube::new(network.nodes[node], axes, half))));
    }
    let slope = (0.5 * narrowest).tangent() / APART;
    let least = (reach / slope).max(options.end_offset * radius);
    if least <= farthest {
        return Ok(Node::Joint { reach, distance: least });
    }
    Ok(Node::Joint { reach: reach.min(farthest * slope), distance: farthest })
}

/// The least angle between two of some directions.
fn narrowest(directions: &[Vector3]) -> f64 {
    let mut least = f64::INFINITY;
    for (k, a) in directions.iter().enumerate() {
        for b in directions.iter().skip(k + 1) {
            least = least.min(a.angle_to(*b).unwrap_or(0.0));
        }
    }
    least
}
