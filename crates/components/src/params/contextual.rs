//! Params / Util: inputs of the definition, which whoever solves it fills in. Left alone they have their own
//! data.

use katydid_component::{Context, component};
use katydid_data::{Tree, Value};

/// Warns when the data is fewer or more items than the input wants; a limit of all 32 bits is none.
fn count(context: &Context<'_>, data: &Tree) {
    let settings = context.settings();
    if data.is_empty() || settings.bool("TreeAccess") == Some(true) {
        return;
    }
    let n = i64::try_from(data.item_count()).unwrap_or(i64::MAX);
    if let Some(least) = settings.i32("AtLeast").map(i64::from).filter(|least| n < *least) {
        context.warn(format!("At least {least} values are wanted, not {n}"));
    }
    if let Some(most) = settings.i32("AtMost").map(i64::from).filter(|most| n > *most) {
        context.warn(format!("At most {most} values are wanted, not {n}"));
    }
}

/// Numbers outside the input's limits are set to the limit, with a warning.
fn limited(context: &Context<'_>, data: &Tree) -> Tree {
    let settings = context.settings();
    let least = settings.f64("Minimum").unwrap_or(f64::NEG_INFINITY);
    let most = settings.f64("Maximum").unwrap_or(f64::INFINITY);
    let inside = |x: f64| !(x < least || x > most);
    let number = |value: &Value| match value {
        Value::Number(x) => Some(*x),
        Value::Integer(i) => Some(f64::from(*i)),
        _ => None,
    };
    if data.column().iter().flatten().filter_map(|v| number(&v)).all(inside) {
        return data.clone();
    }
    context.warn(format!("Values are limited to {least} to {most}"));
    let fit = |value: Value| match value {
        Value::Number(x) => Value::Number(x.min(most).max(least)),
        Value::Integer(i) => {
            let x = f64::from(i).min(most.floor()).max(least.ceil());
            Value::Integer(x.clamp(f64::from(i32::MIN), f64::from(i32::MAX)) as i32)
        }
        other => other,
    };
    let fitted = data.column().iter().map(|item| item.map(fit)).collect();
    data.with_column(katydid_data::Column::of_options(fitted))
}

macro_rules! contextual {
    ($($(#[doc = $help:tt])+ $function:ident, $guid:tt, $name:tt, $kind:ident, $fit:expr;)*) => {$(
        $(#[doc = $help])+
        #[component($guid, name = $name, nick = $name, at = "Params/Util", floating)]
        #[output($name, $name, "The data.", kind = $kind)]
        fn $function(
            context: &Context<'_>,
            #[doc = "What the input has when nobody fills it in."]
            #[port($name, $name, optional, kind = $kind)]
            data: &Tree,
        ) -> Tree {
            count(context, data);
            $fit(context, data)
        }
    )*};
}

fn same(_: &Context<'_>, data: &Tree) -> Tree {
    data.clone()
}

contextual! {
    /// Numbers that the definition asks for. Those outside its limits are set to the limit.
    get_number, "7b36b876-9451-46f5-8220-a200d969cc66", "Get Number", Number, limited;

    /// Whole numbers that the definition asks for. Those outside its limits are set to the limit.
    get_integer, "b228887e-0852-4d9f-bd46-2591646e0d7c", "Get Integer", Integer, limited;

    /// Points that the definition asks for.
    get_point, "997704ba-c1d3-4262-9090-927c81347ce6", "Get Point", Point, same;

    /// Lines that the definition asks for.
    get_line, "af519c71-7dc1-4524-b8cc-add5544e2ef6", "Get Line", Line, same;

    /// Texts that the definition asks for.
    get_string, "fed87bdd-8327-49cd-949c-09d70f3c345c", "Get String", Text, same;

    /// Truth values that the definition asks for.
    get_boolean, "51ef601d-f86e-4ee4-bcf2-3d459d3e95e9", "Get Boolean", Boolean, same;

    /// Geometry that the definition asks for.
    get_geometry, "41dd7ba9-1f53-49d9-af42-a9270b0e9454", "Get Geometry", Geometry, same;

    /// Paths of files that the definition asks for.
    get_file_path, "e83dd8b2-42aa-41e6-9254-882cddec0a2e", "Get File Path", Text, same;
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    #[test]
    fn inputs_have_their_own_data() {
        for name in ["Get Number", "Get Integer", "Get String", "Get File Path"] {
            assert_eq!(Trial::of(name).item(3).texts(0), ["{0}: 3"], "{name}");
        }
        assert_eq!(Trial::of("Get Boolean").item("yes").texts(0), ["{0}: True"]);
        assert_eq!(Trial::of("Get Point").item("1,2,3").texts(0), ["{0}: {1, 2, 3}"]);
        let line = katydid_geometry::Line::new(
            katydid_geometry::Point3::ORIGIN,
            katydid_geometry::Point3::new(2.0, 0.0, 0.0),
        );
        assert_eq!(Trial::of("Get Line").item(line).texts(0), ["{0}: Line(L:2.00 mm)"]);
        assert_eq!(Trial::of("Get Geometry").item("1,2,3").texts(0), ["{0}: {1, 2, 3}"]);
    }

    #[test]
    fn limits_hold() {
        let trial =
            || Trial::of("Get Number").setting("Minimum", 1.0).setting("Maximum", 5.0).list([0.0, 3.0, 9.0]);
        assert_eq!(trial().texts(0), ["{0}: 1, 3, 5"]);
        assert_eq!(trial().message(), "Values are limited to 1 to 5");
        let whole = Trial::of("Get Integer").setting("Minimum", -1e308).setting("Maximum", 2.5).list([-7, 9]);
        assert_eq!(whole.texts(0), ["{0}: -7, 2"]);
        let many = Trial::of("Get String").setting("AtLeast", 1).setting("AtMost", 1).list(["a", "b"]);
        assert_eq!(many.message(), "At most 1 values are wanted, not 2");
    }
}
