//! Numbers of things, for people.

/// A number and what it counts: `1 tick`, `10,000 ticks`.
pub(crate) fn counted(count: u64, thing: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{} {thing}{plural}", grouped(count))
}

/// A number with commas between its thousands.
pub(crate) fn grouped(count: u64) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Commas stand before every third digit from the right, and only inside.
    #[test]
    fn thousands_are_grouped() {
        let cases = [(0, "0"), (999, "999"), (1000, "1,000"), (123_456, "123,456")];
        for (count, text) in cases {
            assert_eq!(grouped(count), text);
        }
        assert_eq!(counted(1, "tick"), "1 tick");
        assert_eq!(counted(1_234_567, "tick"), "1,234,567 ticks");
    }
}
