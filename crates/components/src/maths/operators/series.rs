//! Adding up to a goal.

use katydid_component::{Context, List, Message, component};

/// Adds numbers to a start, again and again in their order, until a goal is reached or passed.
///
/// Numbers that lead away from the goal, or nowhere, are an error.
#[component(
    "586706a8-109b-43ec-b581-743e920c951a",
    name = "Series Addition",
    nick = "SA",
    at = "Maths/Operators"
)]
#[output("Series", "S", "The sum after each number.")]
#[output("Remainder", "R", "The goal less the last sum.")]
fn series_addition(
    context: &Context<'_>,
    /// The numbers to add.
    #[port("Numbers", "N")]
    numbers: List<i32>,
    /// The sum to reach.
    #[port("Goal", "G")]
    goal: i32,
    /// The sum to begin with.
    #[port("Start", "S", default = 0)]
    start: i32,
) -> Result<(Vec<i32>, i32), Message> {
    let numbers: Vec<i64> = numbers.present().map(i64::from).collect();
    let goal = i64::from(goal);
    let mut sum = i64::from(start);
    let upwards = goal >= sum;
    let reached = |sum: i64| if upwards { sum >= goal } else { sum <= goal };
    let mut sums = Vec::new();
    let too_large = || Message::error("A sum does not fit a whole number of 32 bits");
    while !reached(sum) {
        let before = sum;
        for number in &numbers {
            sum += number;
            sums.push(i32::try_from(sum).map_err(|_| too_large())?);
            if reached(sum) {
                break;
            }
        }
        if !reached(sum) && (sum == before || (sum > before) != upwards) {
            return Err(Message::error(format!("These numbers never reach {goal}")));
        }
        context.items(sums.len())?;
        context.check()?;
    }
    Ok((sums, i32::try_from(goal - sum).map_err(|_| too_large())?))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    #[test]
    fn sums_up_to_a_goal() {
        let trial = || Trial::of("Series Addition").list([3, 4]).item(15).item(1);
        assert_eq!(trial().texts(0), ["{0;0}: 4, 8, 11, 15"]);
        assert_eq!(trial().texts(1), ["{0}: 0"]);
        assert_eq!(Trial::of("Series Addition").list([-4]).item(-9).item(0).texts(1), ["{0}: 3"]);
        assert_eq!(Trial::of("Series Addition").list([0]).item(5).message(), "These numbers never reach 5");
        assert_eq!(Trial::of("Series Addition").list([3]).item(-5).message(), "These numbers never reach -5");
        assert_eq!(Trial::of("Series Addition").list([3]).item(0).run().outputs[0].item_count(), 0);
    }
}
