//! Arithmetic in number fields: `20*1.5`, `3mm + 2`, `(10 − 4)/2`.

/// The value of an expression of numbers, `+ − * /` and parentheses. `number` gives the value of a number with the unit
/// that follows it, which may be empty. `None` where the text is not such an expression, or where the value is not
/// finite.
#[must_use]
pub fn evaluate(text: &str, number: &dyn Fn(f64, &str) -> Option<f64>) -> Option<f64> {
    let text: String = text.chars().filter(|letter| !letter.is_whitespace()).collect();
    let text =
        text.replace('−', "-").replace(['×', '·'], "*").replace('÷', "/").replace(',', ".").to_lowercase();
    let mut parser = Parser { left: &text, number };
    let value = parser.sum()?;
    (parser.left.is_empty() && value.is_finite()).then_some(value)
}

/// The rest of the text, which is still to be read.
struct Parser<'a> {
    left: &'a str,
    number: &'a dyn Fn(f64, &str) -> Option<f64>,
}

impl<'a> Parser<'a> {
    /// Reads the next character if it is one of these signs.
    fn sign(&mut self, signs: &[char]) -> Option<char> {
        let first = self.left.chars().next().filter(|first| signs.contains(first))?;
        self.left = &self.left[first.len_utf8()..];
        Some(first)
    }

    fn sum(&mut self) -> Option<f64> {
        let mut value = self.product()?;
        while let Some(sign) = self.sign(&['+', '-']) {
            let next = self.product()?;
            value += if sign == '+' { next } else { -next };
        }
        Some(value)
    }

    fn product(&mut self) -> Option<f64> {
        let mut value = self.factor()?;
        while let Some(sign) = self.sign(&['*', '/']) {
            let next = self.factor()?;
            value = if sign == '*' { value * next } else { value / next };
        }
        Some(value)
    }

    fn factor(&mut self) -> Option<f64> {
        if let Some(sign) = self.sign(&['+', '-']) {
            let value = self.factor()?;
            return Some(if sign == '-' { -value } else { value });
        }
        if self.sign(&['(']).is_some() {
            let value = self.sum()?;
            self.sign(&[')'])?;
            return Some(value);
        }
        let digits = self.take(number_end(self.left));
        let value: f64 = digits.parse().ok()?;
        let is_sign = |letter: char| "+-*/()".contains(letter);
        let unit = self.take(self.left.find(is_sign).unwrap_or(self.left.len()));
        (self.number)(value, unit)
    }

    fn take(&mut self, length: usize) -> &'a str {
        let (taken, left) = self.left.split_at(length);
        self.left = left;
        taken
    }
}

/// Length of the number at the beginning of a text, with its exponent: `1e-3`.
fn number_end(text: &str) -> usize {
    let digits = |from: usize| {
        let is_no_digit = |letter: char| !letter.is_ascii_digit() && letter != '.';
        text[from..].find(is_no_digit).map_or(text.len(), |length| from + length)
    };
    let end = digits(0);
    let Some(exponent) = text[end..].strip_prefix('e') else { return end };
    let sign = usize::from(exponent.starts_with(['+', '-']));
    let from = end + 1 + sign;
    let with_exponent = digits(from);
    if with_exponent > from { with_exponent } else { end }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn expressions_are_computed_as_they_are_written() {
        let plain = |text| evaluate(text, &|value, unit| unit.is_empty().then_some(value));
        for (text, value) in [
            ("20*1.5", 30.0),
            ("2+3*4", 14.0),
            ("(2 + 3) × 4", 20.0),
            ("10/4", 2.5),
            ("−3 − −2", -1.0),
            ("1e-1+1", 1.1),
            ("2,5", 2.5),
        ] {
            assert_eq!(plain(text), Some(value), "{text}");
        }
        for text in ["", "2+", "(2", "2)", "two", "1/0", "2 3x", "*2"] {
            assert_eq!(plain(text), None, "{text}");
        }
    }

    #[test]
    fn each_number_can_have_its_own_unit() {
        let in_mm = |value, unit: &str| match unit {
            "" | "mm" => Some(value),
            "cm" => Some(10.0 * value),
            _ => None,
        };
        assert_eq!(evaluate("1cm + 2*3 mm - 1", &in_mm), Some(15.0));
        assert_eq!(evaluate("1 cm + 2 apples", &in_mm), None);
    }
}
