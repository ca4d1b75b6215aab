//! Measures every operation beside curvo and prints a table: `cargo run --release -p katydid-kernel-bench --bin
//! ratios [WORD…]`. With words only the operations whose names hold one of them.

use std::error::Error;
use std::time::Duration;

use katydid_kernel_bench::Inputs;
use katydid_kernel_bench::operations::{self, Operation};
use katydid_kernel_bench::timing::{Contender, compete};

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let inputs = Inputs::read()?;
    println!("| operation | Katydid ns | peer ns | ratio | wanted | met | others ns |");
    println!("| --- | --- | --- | --- | --- | --- | --- |");
    let chosen = |o: &Operation| words.is_empty() || words.iter().any(|w| o.name.contains(w.as_str()));
    for mut row in operations::all(&inputs)?.into_iter().filter(chosen) {
        let slow = row.contenders.iter().map(|c| c.items).max() == Some(1);
        let (rounds, turn) =
            if slow { (9, Duration::from_millis(3)) } else { (61, Duration::from_micros(700)) };
        compete(&mut row.contenders, rounds, turn);
        print(&row);
    }
    Ok(())
}

fn print(row: &Operation) {
    let of = |name: &str| row.contenders.iter().find(|c| c.name == name).map(Contender::typical);
    let (ours, peer) = (of("katydid").unwrap_or(f64::NAN), of(row.peer).unwrap_or(f64::NAN));
    let others: Vec<String> = row
        .contenders
        .iter()
        .filter(|c| c.name != "katydid" && c.name != row.peer)
        .map(|c| format!("{} {}", c.name, number(c.typical())))
        .collect();
    let ratio = ours / peer;
    let met = if ratio <= row.wanted { "yes" } else { "**no**" };
    println!(
        "| {} | {} | {} {} | {ratio:.4} | {} | {met} | {} |",
        row.name,
        number(ours),
        row.peer,
        number(peer),
        row.wanted,
        others.join(", ")
    );
}

fn number(x: f64) -> String {
    if x < 100.0 { format!("{x:.1}") } else { format!("{x:.0}") }
}
