//! Damages archives at random and reads them: `damage FOLDER CUTS FLIPS [SEED [PART PARTS]]`.
//!
//! Of every .3dm file in the folder CUTS copies are cut off, FLIPS have bytes changed, CUTS have numbers set to what counts
//! and lengths must not be, and CUTS have parts put in other places. Each is read as far as it goes, every fourth strictly
//! too; of those that are read some are written and read again. Prints, for each kind of damage, how many were read and
//! refused, the longest time and the highest peak of memory, as the kernel tells them. A panic ends it. With PART and
//! PARTS only the PARTth of so many shares of the files is looked at, so that several can run side by side.

use std::time::{Duration, Instant};

use katydid_3dm::{Limits, Model};

/// A small generator of numbers (splitmix64), so that a seed gives the same damage everywhere.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let x = (self.0 ^ self.0 >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let x = (x ^ x >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        x ^ x >> 31
    }

    fn below(&mut self, end: usize) -> usize {
        usize::try_from(self.next() % end.max(1) as u64).unwrap_or_default()
    }
}

const KINDS: [&str; 4] = ["cut off", "bytes changed", "counts and lengths", "parts swapped"];
const HOSTILE: [u64; 8] =
    [0x7FFF_FFFF, 0xFFFF_FFFF, 0x8000_0000, 0, 1 << 40, u64::MAX, 0x7FFF_FFFF_FFFF_FFFF, 0x0100_0000];

fn damaged(bytes: &[u8], kind: usize, numbers: &mut Numbers) -> Vec<u8> {
    let mut copy = bytes.to_vec();
    match kind {
        0 => copy.truncate(numbers.below(bytes.len())),
        1 => {
            for _ in 0..1 + numbers.below(8) {
                let at = numbers.below(copy.len());
                if let Some(byte) = copy.get_mut(at) {
                    *byte = numbers.next().to_le_bytes()[0];
                }
            }
        }
        2 => {
            let hostile =
                HOSTILE.get(numbers.below(HOSTILE.len())).copied().unwrap_or_default().to_le_bytes();
            let width = if numbers.below(2) == 0 { 4 } else { 8 };
            let at = 32 + numbers.below(copy.len().saturating_sub(40));
            if let (Some(place), Some(hostile)) = (copy.get_mut(at..at + width), hostile.get(..width)) {
                place.copy_from_slice(hostile);
            }
        }
        _ => {
            let (a, b, length) = (numbers.below(copy.len()), numbers.below(copy.len()), numbers.below(200));
            if let Some(part) = bytes.get(a..a + length)
                && let Some(place) = copy.get_mut(b..b + length)
            {
                place.copy_from_slice(part);
            }
        }
    }
    copy
}

/// The peak of memory since it was last set back, in MiB.
fn peak() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.and_then(|line| line.split_whitespace().next()?.parse::<u64>().ok()).unwrap_or_default() / 1024
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [folder, cuts, flips, rest @ ..] = arguments.as_slice() else {
        return Err("usage: damage FOLDER CUTS FLIPS [SEED [PART PARTS]]".into());
    };
    let (cuts, flips): (usize, usize) = (cuts.parse()?, flips.parse()?);
    let (part, parts): (usize, usize) = match rest {
        [_, part, parts, ..] => (part.parse()?, parts.parse()?),
        _ => (0, 1),
    };
    let mut numbers = Numbers(rest.first().map_or(Ok(1), |seed| seed.parse())?);
    let mut files: Vec<_> = std::fs::read_dir(folder)?.collect::<Result<_, _>>()?;
    files.retain(|file| file.path().extension().is_some_and(|e| e == "3dm"));
    files.sort_by_key(std::fs::DirEntry::path);
    let mut place = 0..;
    files.retain(|_| place.next().is_some_and(|place: usize| place % parts == part));
    for (kind, name) in KINDS.iter().enumerate() {
        let cases = if kind == 1 { flips } else { cuts };
        let (mut read_at_all, mut refused) = (0, 0);
        let (mut strictly, mut faulty) = (0, 0);
        let (mut longest, mut highest, mut worst) = (Duration::ZERO, 0, String::new());
        for file in &files {
            let bytes = std::fs::read(file.path())?;
            for case in 0..cases {
                let broken = damaged(&bytes, kind, &mut numbers);
                // Sets the peak back, where the system can.
                let _ = std::fs::write("/proc/self/clear_refs", "5");
                let start = Instant::now();
                let read = Model::read(&broken, &Limits::default());
                let time = start.elapsed();
                highest = highest.max(peak());
                if time > longest {
                    (longest, worst) = (time, format!("{} case {case}", file.path().display()));
                }
                match &read {
                    Ok(_) => read_at_all += 1,
                    Err(_) => refused += 1,
                }
                if case % 4 == 0 {
                    match (&read, Model::read_strict(&broken, &Limits::default())) {
                        (Err(error), Ok(_)) => return Err(format!("strict reads what fails: {error}").into()),
                        (_, Ok(_)) => strictly += 1,
                        (_, Err(_)) => faulty += 1,
                    }
                }
                if let Ok(model) = read.as_ref()
                    && case % 16 == 0
                    && let Ok(written) = model.write([4, 50, 60, 70, 80][case / 16 % 5])
                {
                    // Objects kept as bytes may be broken inside, but none is lost.
                    let again = Model::read(&written, &Limits::default())?;
                    if again.objects.len() != model.objects.len() {
                        return Err(format!("{} case {case}: objects are lost", file.path().display()).into());
                    }
                }
            }
        }
        println!(
            "{name}: {read_at_all} read, {refused} refused (strictly {strictly}, {faulty}); longest {longest:.1?} ({worst}), peak {highest} MiB"
        );
    }
    Ok(())
}
