//! Reads what the report of a growth says about each drawn mark.

use serde_json::Value;

/// For each mark, in the order of the document: whether the report says that it is there; `None` where the report does
/// not list marks.
///
/// The list is `"drawn": [{"mark": …, "there": …}]` of a layer; marks are counted from 0.
pub fn there(report: &Value, layer: usize, marks: usize) -> Option<Vec<bool>> {
    let entries = report["layers"][layer]["drawn"].as_array()?;
    let of = |mark: usize| {
        let entry = entries.iter().find(|entry| entry["mark"].as_u64() == Some(mark as u64));
        entry.is_some_and(|entry| entry["there"].as_bool() == Some(true))
    };
    Some((0..marks).map(of).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn marks_are_read_by_their_number_and_a_report_without_a_list_says_nothing() {
        let report =
            json!({"layers": [{"drawn": [{"mark": 1, "there": true}, {"mark": 0, "there": false}]}]});
        assert_eq!(there(&report, 0, 2), Some(vec![false, true]));
        assert_eq!(there(&json!({"layers": [{}]}), 0, 2), None);
    }
}
