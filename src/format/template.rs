/// A template with `{{name}}` replaced by the contents of that name, by nothing where there are none.
pub(super) fn filled(template: &str, contents: &[(&str, String)]) -> String {
    let mut parts = template.split("{{");
    let mut written = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (name, rest) = part.split_once("}}").unwrap_or((part, ""));
        let content = contents.iter().find(|(known, _)| *known == name);
        written.push_str(content.map_or("", |(_, text)| text));
        written.push_str(rest);
    }
    written
}
