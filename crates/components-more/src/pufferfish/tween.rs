//! Tweens and averages of all types but planes, which may turn by quaternions.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Colour, Item};
use katydid_geometry::{Curve, Interval, Mesh, Point3, Surface, Vector3, Xform};

use super::mix::Mix;
use super::weights::{Way, between, pairs, weights};

/// Says what is not supported of a way through a set.
pub(super) fn unsupported(context: &Context<'_>, equalized: bool, weighted: bool) {
    if equalized {
        context.tell(Message::remark("Equalized is not supported: items are equally far apart"));
    }
    if weighted {
        context.tell(Message::remark("Weighted is not supported: items are equally far apart"));
    }
}

/// Items of a set blended by shares.
fn blended<T: Mix + Clone>(
    context: &Context<'_>,
    items: &[T],
    shares: Vec<(usize, f64)>,
) -> Result<T, Message> {
    let parts: Vec<(T, f64)> =
        shares.into_iter().filter_map(|(i, share)| Some((items.get(i)?.clone(), share))).collect();
    T::mix(&parts, context.tolerance().absolute)
}

/// The item of a set at a factor.
pub(super) fn through<T: Mix + Item + Clone>(
    context: &Context<'_>,
    items: &List<'_, T>,
    factor: f64,
    way: Way,
) -> Result<T, Message> {
    let items: Vec<T> = items.present().collect();
    blended(context, &items, weights(items.len(), factor, way)?)
}

/// The item at a factor between each two neighbours.
pub(super) fn consecutive<T: Mix + Item + Clone>(
    context: &Context<'_>,
    items: &List<'_, T>,
    factor: f64,
    closed: bool,
    smooth: bool,
) -> Result<Vec<T>, Message> {
    let items: Vec<T> = items.present().collect();
    context.items(items.len())?;
    let way = Way { normalized: false, closed, smooth };
    pairs(items.len(), closed)
        .into_iter()
        .map(|pair| {
            context.check()?;
            blended(context, &items, between(items.len(), pair, factor, way)?)
        })
        .collect()
}

/// The mean of a set, by weights where there are some.
fn mean<T: Mix + Item>(context: &Context<'_>, items: &List<'_, T>, weights: &[f64]) -> Result<T, Message> {
    let items: Vec<T> = items.present().collect();
    if items.is_empty() {
        return Err(Message::warning("There is nothing to average"));
    }
    let weight = |i: usize| match weights {
        [] => 1.0,
        some => some.get(i).or(some.last()).copied().unwrap_or(1.0),
    };
    let total: f64 = (0..items.len()).map(weight).sum();
    if !(total.is_finite() && total != 0.0) {
        return Err(Message::error("The weights add up to nothing"));
    }
    let parts: Vec<(T, f64)> =
        items.into_iter().enumerate().map(|(i, item)| (item, weight(i) / total)).collect();
    T::mix(&parts, context.tolerance().absolute)
}

/// Tween Two, Tween Consecutive and Tween Through of one type.
macro_rules! tweens {
    (
        $type:ty, $panel:tt, $one_a:tt, $one_b:tt, $many:tt, $many_nick:tt,
        two $two:ident $two_id:tt $two_name:tt $two_nick:tt $two_help:tt;
        consecutive $con:ident $con_id:tt $con_name:tt $con_nick:tt $con_help:tt;
        through $thru:ident $thru_id:tt $thru_name:tt $thru_nick:tt $thru_help:tt;
    ) => {
        #[doc = $two_help]
        #[component($two_id, name = $two_name, nick = $two_nick, at = $panel)]
        #[output("Tween", "T", "What lies between.")]
        fn $two(
            context: &Context<'_>,
            /// What factor 0 gives.
            #[port($one_a, "A")]
            a: $type,
            /// What factor 1 gives.
            #[port($one_b, "B")]
            b: $type,
            /// 0 gives A, 1 gives B; other numbers go beyond them.
            #[port("Factor", "F", default = 0.5)]
            factor: f64,
        ) -> Result<$type, Message> {
            if !factor.is_finite() {
                return Err(Message::error("The factor is not finite"));
            }
            <$type>::mix(&[(a, 1.0 - factor), (b, factor)], context.tolerance().absolute)
        }

        #[doc = $con_help]
        #[component($con_id, name = $con_name, nick = $con_nick, at = $panel)]
        #[output("Tween", "T", "What lies between each two neighbours.")]
        fn $con(
            context: &Context<'_>,
            /// The set.
            #[port($many, $many_nick)]
            items: List<$type>,
            /// 0 gives the first of each two neighbours, 1 the second.
            #[port("Factor", "F", default = 0.5)]
            factor: f64,
            /// Whether what lies far apart counts more, which is not supported.
            #[port("Weighted", "W", default = false)]
            weighted: bool,
            /// Whether the set goes on from its last item to its first.
            #[port("Loopback", "L", default = false)]
            closed: bool,
            /// 1 goes straight between neighbours, more by curves.
            #[port("Degree", "D", default = 1)]
            degree: i32,
            /// The spacing of curves, which does not count here.
            #[port("Interpolation Type", "I", optional)]
            _spacing: Option<i32>,
        ) -> Result<Vec<$type>, Message> {
            unsupported(context, false, weighted);
            consecutive(context, &items, factor, closed, degree > 1)
        }

        #[doc = $thru_help]
        #[component($thru_id, name = $thru_name, nick = $thru_nick, at = $panel)]
        #[output("Tween", "T", "What lies at the factor.")]
        fn $thru(
            context: &Context<'_>,
            /// The set.
            #[port($many, $many_nick)]
            items: List<$type>,
            /// 0 gives the first item, 1 the last.
            #[port("Factor", "F", default = 0.5)]
            factor: f64,
            /// Whether the factor goes from 0 to 1; else it counts the items.
            #[port("Normalized", "N", default = true)]
            normalized: bool,
            /// Whether the way is divided by its length, which is not supported.
            #[port("Equalized", "E", default = false)]
            equalized: bool,
            /// Whether what lies far apart counts more, which is not supported.
            #[port("Weighted", "W", default = false)]
            weighted: bool,
            /// Whether the set goes on from its last item to its first.
            #[port("Loopback", "L", default = false)]
            closed: bool,
            /// 1 goes straight between neighbours, more by curves.
            #[port("Degree", "D", default = 1)]
            degree: i32,
            /// The spacing of curves, which does not count here.
            #[port("Interpolation Type", "I", optional)]
            _spacing: Option<i32>,
        ) -> Result<$type, Message> {
            unsupported(context, equalized, weighted);
            through(context, &items, factor, Way { normalized, closed, smooth: degree > 1 })
        }
    };
}

tweens! {
    f64, "Pufferfish/Number", "Number A", "Number B", "Numbers", "Nu",
    two two_numbers "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3001" "Tween Two Numbers" "Twn2Nums"
        "A number between two. Stands for Pufferfish's Tween Two Numbers.";
    consecutive consecutive_numbers "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3002" "Tween Consecutive Numbers" "TwnConNums"
        "Numbers between neighbours of a set. Stands for Pufferfish's Tween Consecutive Numbers.";
    through through_numbers "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3003" "Tween Through Numbers" "TwnThruNums"
        "A number on the way through a set. Stands for Pufferfish's Tween Through Numbers.";
}
tweens! {
    Interval, "Pufferfish/Domain", "Domain A", "Domain B", "Domains", "Do",
    two two_domains "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3004" "Tween Two Domains" "Twn2Doms"
        "A domain between two. Stands for Pufferfish's Tween Two Domains.";
    consecutive consecutive_domains "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3005" "Tween Consecutive Domains" "TwnConDoms"
        "Domains between neighbours of a set. Stands for Pufferfish's Tween Consecutive Domains.";
    through through_domains "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3006" "Tween Through Domains" "TwnThruDoms"
        "A domain on the way through a set. Stands for Pufferfish's Tween Through Domains.";
}
tweens! {
    Point3, "Pufferfish/Point", "Point A", "Point B", "Points", "P",
    two two_points "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3007" "Tween Two Points" "Twn2Pts"
        "A point between two. Stands for Pufferfish's Tween Two Points.";
    consecutive consecutive_points "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3008" "Tween Consecutive Points" "TwnConPts"
        "Points between neighbours of a set. Stands for Pufferfish's Tween Consecutive Points.";
    through through_points "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3009" "Tween Through Points" "TwnThruPts"
        "A point on the way through a set. Stands for Pufferfish's Tween Through Points.";
}
tweens! {
    Vector3, "Pufferfish/Vector", "Vector A", "Vector B", "Vectors", "V",
    two two_vectors "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f300a" "Tween Two Vectors" "Twn2Vecs"
        "A vector between two. Stands for Pufferfish's Tween Two Vectors.";
    consecutive consecutive_vectors "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f300b" "Tween Consecutive Vectors" "TwnConVecs"
        "Vectors between neighbours of a set. Stands for Pufferfish's Tween Consecutive Vectors.";
    through through_vectors "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f300c" "Tween Through Vectors" "TwnThruVecs"
        "A vector on the way through a set. Stands for Pufferfish's Tween Through Vectors.";
}
tweens! {
    Colour, "Pufferfish/Color", "Color A", "Color B", "Colors", "C",
    two two_colours "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f300d" "Tween Two Colors" "Twn2Cols"
        "A colour between two, channel by channel. Stands for Pufferfish's Tween Two Colors.";
    consecutive consecutive_colours "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f300e" "Tween Consecutive Colors" "TwnConCols"
        "Colours between neighbours of a set. Stands for Pufferfish's Tween Consecutive Colors.";
    through through_colours "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f300f" "Tween Through Colors" "TwnThruCols"
        "A colour on the way through a set. Stands for Pufferfish's Tween Through Colors.";
}
tweens! {
    Xform, "Pufferfish/Transform", "Transform A", "Transform B", "Transforms", "X",
    two two_transforms "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3010" "Tween Two Transforms" "Twn2Trans"
        "A transform between two, number by number. Stands for Pufferfish's Tween Two Transforms.";
    consecutive consecutive_transforms "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3011" "Tween Consecutive Transforms" "TwnConTrans"
        "Transforms between neighbours of a set. Stands for Pufferfish's Tween Consecutive Transforms.";
    through through_transforms "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3012" "Tween Through Transforms" "TwnThruTrans"
        "A transform on the way through a set. Stands for Pufferfish's Tween Through Transforms.";
}
tweens! {
    Shared<Mesh>, "Pufferfish/Mesh", "Mesh A", "Mesh B", "Meshes", "M",
    two two_meshes "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3013" "Tween Two Meshes" "Twn2Mshs"
        "A mesh between two with the same vertices and faces; colours where both have some. Stands for Pufferfish's Tween Two Meshes.";
    consecutive consecutive_meshes "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3014" "Tween Consecutive Meshes" "TwnConMshs"
        "Meshes between neighbours of a set. Stands for Pufferfish's Tween Consecutive Meshes.";
    through through_meshes "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3015" "Tween Through Meshes" "TwnThruMshs"
        "A mesh on the way through a set. Stands for Pufferfish's Tween Through Meshes.";
}
tweens! {
    Shared<Surface>, "Pufferfish/Surface", "Surface A", "Surface B", "Surfaces", "S",
    two two_surfaces "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3016" "Tween Two Surfaces" "Twn2Srfs"
        "A surface between two, by their control points; trims do not count, Refit and Point Sample are not supported. Stands for Pufferfish's Tween Two Surfaces.";
    consecutive consecutive_surfaces "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3017" "Tween Consecutive Surfaces" "TwnConSrfs"
        "Surfaces between neighbours of a set; trims do not count. Stands for Pufferfish's Tween Consecutive Surfaces.";
    through through_surfaces "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3018" "Tween Through Surfaces" "TwnThruSrfs"
        "A surface on the way through a set; trims do not count. Stands for Pufferfish's Tween Through Surfaces.";
}

/// The average and the weighted average of one type.
macro_rules! averages {
    (
        $type:ty, $panel:tt, $many:tt, $many_nick:tt,
        $plain:ident $plain_id:tt $plain_name:tt $plain_nick:tt $plain_help:tt;
        $weighted:ident $weighted_id:tt $weighted_name:tt $weighted_nick:tt $weighted_help:tt;
    ) => {
        #[doc = $plain_help]
        #[component($plain_id, name = $plain_name, nick = $plain_nick, at = $panel)]
        #[output("Arithmetic mean", "AM", "The mean.")]
        fn $plain(
            context: &Context<'_>,
            /// The set.
            #[port($many, $many_nick)]
            items: List<$type>,
        ) -> Result<$type, Message> {
            mean(context, &items, &[])
        }

        #[doc = $weighted_help]
        #[component($weighted_id, name = $weighted_name, nick = $weighted_nick, at = $panel)]
        #[output("Arithmetic mean", "AM", "The mean.")]
        fn $weighted(
            context: &Context<'_>,
            /// The set.
            #[port($many, $many_nick)]
            items: List<$type>,
            /// The weight of each; the last one goes on.
            #[port("Weights", "W")]
            weights: List<f64>,
        ) -> Result<$type, Message> {
            mean(context, &items, &weights.present().collect::<Vec<f64>>())
        }
    };
}

averages! {
    Interval, "Pufferfish/Domain", "Domains", "D",
    average_domain "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3019" "Average Domain" "AvrDom"
        "The mean of domains. Stands for Pufferfish's Average Domain.";
    weighted_domain "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f301a" "Weighted Average Domain" "WavDom"
        "The weighted mean of domains. Stands for Pufferfish's Weighted Average Domain.";
}
averages! {
    Shared<Curve>, "Pufferfish/Curve", "Curves", "C",
    average_curve "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f301b" "Average Curve" "AvrCrv"
        "The mean of curves, by their control points; Refit and Point Sample are not supported. Stands for Pufferfish's Average Curve.";
    weighted_curve "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f301c" "Weighted Average Curve" "WavCrv"
        "The weighted mean of curves, by their control points. Stands for Pufferfish's Weighted Average Curve.";
}
averages! {
    Shared<Mesh>, "Pufferfish/Mesh", "Meshes", "M",
    average_mesh "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f301d" "Average Mesh" "AvrMsh"
        "The mean of meshes with the same vertices and faces. Stands for Pufferfish's Average Mesh.";
    weighted_mesh "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f301e" "Weighted Average Mesh" "WavMsh"
        "The weighted mean of meshes with the same vertices and faces. Stands for Pufferfish's Weighted Average Mesh.";
}
averages! {
    Shared<Surface>, "Pufferfish/Surface", "Surfaces", "S",
    average_surface "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f301f" "Average Surface" "AvrSrf"
        "The mean of surfaces, by their control points; trims do not count. Stands for Pufferfish's Average Surface.";
    weighted_surface "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3020" "Weighted Average Surface" "WavSrf"
        "The weighted mean of surfaces, by their control points. Stands for Pufferfish's Weighted Average Surface.";
}
averages! {
    katydid_geometry::Plane, "Pufferfish/Plane", "Planes", "Pl",
    average_plane "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3021" "Average Plane" "AvrPln"
        "The mean of planes, by origins and axes. Stands for Pufferfish's Average Plane.";
    weighted_plane "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3022" "Weighted Average Plane" "WavPln"
        "The weighted mean of planes, by origins and axes. Stands for Pufferfish's Weighted Average Plane.";
}
averages! {
    Xform, "Pufferfish/Transform", "Transforms", "X",
    average_transform "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3023" "Average Transform" "AvrTran"
        "The mean of transforms, number by number. Stands for Pufferfish's Average Transform.";
    weighted_transform "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3024" "Weighted Average Transform" "WavTran"
        "The weighted mean of transforms, number by number. Stands for Pufferfish's Weighted Average Transform.";
}
