//! Arcs, ellipses, rectangles, boxes and the round solids.

use std::f64::consts::TAU;

use katydid_geometry::{
    Arc, Box3, Circle, Cone, Cylinder, Ellipse, Interval, Plane, Rectangle, Sphere, Torus,
};
use serde_json::{Value as Json, json};

use super::numbers::number;
use super::read::{Members, plane_of};
use super::{Wire, made, no};
use crate::Fault;

impl Wire for Arc {
    const TYPE: &'static str = "Rhino.Geometry.Arc";
    const NAME: &'static str = "an arc";

    /// A plane, a radius and the angles: `AngleDomain`, or `StartAngle` and `EndAngle`, or `Angle` from 0 on, or a full
    /// turn when none is there.
    fn from_json(json: &Json) -> Result<Self, Fault> {
        let read = || -> Result<_, Fault> {
            let members = Members::of(json)?;
            let plane = plane_of(&members, &["Plane"], "Normal")?;
            let angles = if members.get("AngleDomain").is_some() {
                members.read("AngleDomain")?
            } else {
                let start: f64 = members.read_or("StartAngle", 0.0)?;
                let angle = members.read_or("Angle", TAU)?;
                Interval::new(start, members.read_or("EndAngle", start + angle)?)
            };
            Ok((plane, members.read("Radius")?, angles))
        };
        let (plane, radius, angles): (Plane, f64, Interval) = read().map_err(no::<Self>)?;
        made(Circle::new(plane, radius).and_then(|circle| Self::new(circle, angles)))
    }

    fn to_json(&self, archive: i32) -> Result<Json, Fault> {
        Ok(json!({
            "Plane": self.circle.plane.to_json(archive)?,
            "Radius": number(self.circle.radius),
            "Center": self.circle.center().to_json(archive)?,
            "StartPoint": self.start().to_json(archive)?,
            "MidPoint": self.midpoint().to_json(archive)?,
            "EndPoint": self.end().to_json(archive)?,
            "AngleDomain": self.angle.to_json(archive)?,
            "StartAngle": number(self.angle.start),
            "EndAngle": number(self.angle.end),
            "Angle": number(self.angle.length()),
            "Length": number(self.length()),
        }))
    }
}

impl Wire for Ellipse {
    const TYPE: &'static str = "Rhino.Geometry.Ellipse";
    const NAME: &'static str = "an ellipse";

    fn from_json(json: &Json) -> Result<Self, Fault> {
        let read = || -> Result<_, Fault> {
            let members = Members::of(json)?;
            Ok((
                plane_of(&members, &["Plane"], "Normal")?,
                members.read("Radius1")?,
                members.read("Radius2")?,
            ))
        };
        let (plane, first, second) = read().map_err(no::<Self>)?;
        made(Self::new(plane, first, second))
    }

    fn to_json(&self, archive: i32) -> Result<Json, Fault> {
        let (plane, first, second) = (self.plane.to_json(archive)?, number(self.rx), number(self.ry));
        Ok(json!({ "Plane": plane, "Radius1": first, "Radius2": second }))
    }
}

impl Wire for Rectangle {
    const TYPE: &'static str = "Rhino.Geometry.Rectangle3d";
    const NAME: &'static str = "a rectangle";

    /// A plane and the ranges `X` and `Y`, or `Width` and `Height` from the plane's origin.
    fn from_json(json: &Json) -> Result<Self, Fault> {
        let read = || -> Result<_, Fault> {
            let members = Members::of(json)?;
            let range = |name, size| match members.get(name) {
                Some(_) => members.read(name),
                None => members.read(size).map(|size| Interval::new(0.0, size)),
            };
            let plane = plane_of(&members, &["Plane"], "Normal")?;
            Ok(Self { plane, x: range("X", "Width")?, y: range("Y", "Height")? })
        };
        read().map_err(no::<Self>)
    }

    fn to_json(&self, archive: i32) -> Result<Json, Fault> {
        let [a, b, c, d] = self.corners();
        Ok(json!({
            "Plane": self.plane.to_json(archive)?,
            "X": self.x.to_json(archive)?,
            "Y": self.y.to_json(archive)?,
            "Width": number(self.x.length()),
            "Height": number(self.y.length()),
            "Center": self.center().to_json(archive)?,
            "Corners": [a.to_json(archive)?, b.to_json(archive)?, c.to_json(archive)?, d.to_json(archive)?],
        }))
    }
}

impl Wire for Box3 {
    const TYPE: &'static str = "Rhino.Geometry.Box";
    const NAME: &'static str = "a box";

    /// A plane and the ranges `X`, `Y` and `Z`; or the `Min` and `Max` of a box along the world's axes.
    fn from_json(json: &Json) -> Result<Self, Fault> {
        let read = || -> Result<_, Fault> {
            let members = Members::of(json)?;
            if members.get("Min").is_some() {
                return katydid_geometry::BoundingBox::from_json(json).map(Self::from);
            }
            let plane = plane_of(&members, &["Plane"], "Normal")?;
            Ok(Self { plane, x: members.read("X")?, y: members.read("Y")?, z: members.read("Z")? })
        };
        read().map_err(no::<Self>)
    }

    fn to_json(&self, archive: i32) -> Result<Json, Fault> {
        Ok(json!({
            "Plane": self.plane.to_json(archive)?,
            "X": self.x.to_json(archive)?,
            "Y": self.y.to_json(archive)?,
            "Z": self.z.to_json(archive)?,
            "Center": self.center().to_json(archive)?,
        }))
    }
}

impl Wire for Sphere {
    const TYPE: &'static str = "Rhino.Geometry.Sphere";
    const NAME: &'static str = "a sphere";

    fn from_json(json: &Json) -> Result<Self, Fault> {
        let read = || -> Result<_, Fault> {
            let members = Members::of(json)?;
            Ok((
                plane_of(&members, &["EquatorialPlane", "EquitorialPlane", "Plane"], "NorthPole")?,
                members.read("Radius")?,
            ))
        };
        let (plane, radius) = read().map_err(no::<Self>)?;
        made(Self::new(plane, radius))
    }

    fn to_json(&self, archive: i32) -> Result<Json, Fault> {
        Ok(json!({
            "Radius": number(self.radius),
            "EquatorialPlane": self.plane.to_json(archive)?,
            "Center": self.center().to_json(archive)?,
        }))
    }
}

impl Wire for Cylinder {
    const TYPE: &'static str = "Rhino.Geometry.Cylinder";
    const NAME: &'static str = "a cylinder";

    /// A plane, a radius and two heights over the plane, or one from it.
    fn from_json(json: &Json) -> Result<Self, Fault> {
        let read = || -> Result<_, Fault> {
            let members = Members::of(json)?;
            let plane = plane_of(&members, &["BasePlane", "Plane"], "Axis")?;
            let height = match members.first(&["Height", "TotalHeight"]) {
                Some(_) if members.get("Height1").is_none() => {
                    let name = if members.get("Height").is_some() { "Height" } else { "TotalHeight" };
                    Interval::new(0.0, members.read(name)?)
                }
                _ => Interval::new(members.read_or("Height1", 0.0)?, members.read("Height2")?),
            };
            Ok((plane, members.read("Radius")?, height))
        };
        let (plane, radius, height) = read().map_err(no::<Self>)?;
        made(Self::new(plane, radius, height))
    }

    fn to_json(&self, archive: i32) -> Result<Json, Fault> {
        Ok(json!({
            "BasePlane": self.plane.to_json(archive)?,
            "Radius": number(self.radius),
            "Height1": number(self.height.start),
            "Height2": number(self.height.end),
        }))
    }
}

impl Wire for Cone {
    const TYPE: &'static str = "Rhino.Geometry.Cone";
    const NAME: &'static str = "a cone";

    fn from_json(json: &Json) -> Result<Self, Fault> {
        let read = || -> Result<_, Fault> {
            let members = Members::of(json)?;
            Ok((plane_of(&members, &["Plane"], "Axis")?, members.read("Height")?, members.read("Radius")?))
        };
        let (plane, height, radius) = read().map_err(no::<Self>)?;
        made(Self::new(plane, height, radius))
    }

    fn to_json(&self, archive: i32) -> Result<Json, Fault> {
        let (plane, height, radius) =
            (self.plane.to_json(archive)?, number(self.height), number(self.radius));
        Ok(json!({ "Plane": plane, "Height": height, "Radius": radius }))
    }
}

impl Wire for Torus {
    const TYPE: &'static str = "Rhino.Geometry.Torus";
    const NAME: &'static str = "a torus";

    fn from_json(json: &Json) -> Result<Self, Fault> {
        let read = || -> Result<_, Fault> {
            let members = Members::of(json)?;
            let plane = plane_of(&members, &["Plane"], "Normal")?;
            Ok((plane, members.read("MajorRadius")?, members.read("MinorRadius")?))
        };
        let (plane, major, minor) = read().map_err(no::<Self>)?;
        made(Self::new(plane, major, minor))
    }

    fn to_json(&self, archive: i32) -> Result<Json, Fault> {
        let (major, minor) = (number(self.major_radius), number(self.minor_radius));
        Ok(json!({ "Plane": self.plane.to_json(archive)?, "MajorRadius": major, "MinorRadius": minor }))
    }
}
