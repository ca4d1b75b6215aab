//! Struts in a row, from joint to joint or all round, and the frames in which their rings stand.

use katydid_elementary::Elementary;

use super::network::MultiPipeNetwork;
use super::node::Node;
use crate::Vector3;

/// Struts in a row: each with whether it is walked from its second end.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Chain {
    pub(super) struts: Vec<(usize, bool)>,
    /// Whether it comes back to where it begins, through rings only.
    pub(super) closed: bool,
}

impl Chain {
    /// The directions of the struts as they are walked.
    pub(super) fn directions(&self, network: &MultiPipeNetwork) -> Vec<Vector3> {
        self.struts.iter().map(|(strut, back)| network.direction((*strut, usize::from(*back)))).collect()
    }

    /// The nodes in order; a closed chain names its first one once.
    pub(super) fn nodes(&self, network: &MultiPipeNetwork) -> Vec<usize> {
        let from = |(strut, back): &(usize, bool)| network.struts[*strut][usize::from(*back)];
        let last = self.struts.last().filter(|_| !self.closed);
        let last = last.map(|(strut, back)| network.struts[*strut][usize::from(!*back)]);
        self.struts.iter().map(from).chain(last).collect()
    }
}

/// All struts in rows.
pub(super) fn chains(network: &MultiPipeNetwork, nodes: &[Node]) -> Vec<Chain> {
    let around = network.around();
    let passes = |node: usize| matches!(nodes[node], Node::Through { .. });
    let mut walked = vec![false; network.struts.len()];
    let mut out = Vec::new();
    let mut walk = |start: (usize, usize), walked: &mut Vec<bool>| {
        let mut struts = Vec::new();
        let (mut strut, mut end) = start;
        let closed = loop {
            walked[strut] = true;
            struts.push((strut, end == 1));
            let node = network.struts[strut][1 - end];
            let next = around[node].iter().copied().find(|(other, _)| *other != strut);
            match next.filter(|_| passes(node)) {
                Some((next, _)) if walked[next] => break next == start.0,
                Some(next) => (strut, end) = next,
                None => break false,
            }
        };
        out.push(Chain { struts, closed });
    };
    for node in (0..nodes.len()).filter(|node| !passes(*node)) {
        for start in &around[node] {
            if !walked[start.0] {
                walk(*start, &mut walked);
            }
        }
    }
    for strut in 0..network.struts.len() {
        if !walked[strut] {
            walk((strut, 0), &mut walked);
        }
    }
    out
}

/// Unit vectors at right angles to directions, each turned as little as can be from the one before.
pub(super) fn carried(first: Vector3, directions: &[Vector3]) -> Vec<Vector3> {
    let mut out = Vec::with_capacity(directions.len());
    let mut frame = first;
    let mut before: Option<Vector3> = None;
    for &direction in directions {
        if let Some(before) = before {
            frame = turned(frame, before, direction);
        }
        frame = frame.rejected_from(direction).and_then(Vector3::unitized).unwrap_or(frame);
        out.push(frame);
        before = Some(direction);
    }
    out
}

/// A vector turned as one direction is turned to another.
pub(super) fn turned(vector: Vector3, from: Vector3, to: Vector3) -> Vector3 {
    let axis = from.cross(to);
    let angle = axis.length().arctangent_of(from.dot(to));
    vector.rotated(angle, axis).unwrap_or(vector)
}

/// How far one vector is turned from another about a direction, less quarter turns: from −π/4 to π/4.
pub(super) fn twist(from: Vector3, to: Vector3, direction: Vector3) -> f64 {
    let quarter = std::f64::consts::FRAC_PI_2;
    let angle = direction.dot(from.cross(to)).arctangent_of(from.dot(to));
    angle - (angle / quarter).round() * quarter
}
