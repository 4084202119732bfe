//! Seconds that a case takes when it is solved many times, without a process for each: `many_beams CASE COUNT`.

#![allow(clippy::print_stdout)] // the purpose of the program

use std::error::Error;
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let case = std::fs::read_to_string(arguments.next().ok_or("the name of a case is missing")?)?;
    let count: u32 = arguments.next().ok_or("a count is missing")?.parse()?;
    let begin = Instant::now();
    for _ in 0..count {
        peristat::solve_text(&case)?;
    }
    println!("{:e}", begin.elapsed().as_secs_f64() / f64::from(count));
    Ok(())
}
