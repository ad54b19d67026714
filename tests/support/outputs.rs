//! What must hold of everything that the program writes, whatever strangers have written into titles, names and labels:
//! other parsers read it back, and nothing in it is obeyed by what shows it.

use lopdf::Document as Pdf;
use resvg::usvg::roxmltree::Document;

/// Characters that a terminal obeys or that mislead a reader of it: C0 but for ends of lines, DEL, C1, separators of lines,
/// marks and overrides of direction (Unicode, "Bidirectional Character Types").
pub fn is_obeyed(c: char) -> bool {
    let code = u32::from(c);
    matches!(code, 0..=9 | 11..=31 | 127..=159 | 0x61c | 0x200e | 0x200f | 0x2028..=0x202e | 0x2066..=0x2069)
}

/// Text for people is in UTF-8, and a terminal shows all of it.
pub fn terminal(bytes: &[u8]) -> String {
    let text = String::from_utf8(bytes.to_vec()).expect("text is UTF-8");
    let obeyed: Vec<char> = text.chars().filter(|&c| is_obeyed(c)).collect();
    assert!(obeyed.is_empty(), "a terminal obeys {obeyed:?} in {text:?}");
    text
}

/// A message besides says nothing at length.
pub fn message(bytes: &[u8]) -> String {
    let text = terminal(bytes);
    let longest = text.lines().map(|line| line.chars().count()).max().unwrap_or(0);
    assert!(longest < 1200, "a line of {longest} characters: {}", text.chars().take(200).collect::<String>());
    text
}

/// Sentences and tables have numbers, none of them infinite or none at all; `given` is what strangers have written.
pub fn numbers(text: &str, given: &str) {
    let is_word = |word: &str| {
        let mut words = text.split(|c: char| !c.is_alphanumeric());
        words.any(|w| w == word)
    };
    for word in ["inf", "NaN"] {
        assert!(given.to_lowercase().contains(&word.to_lowercase()) || !is_word(word), "{word} in {text}");
    }
}

/// A picture is XML without an odd number; its size is one.
pub fn svg(text: &str) {
    terminal(text.as_bytes());
    let document = Document::parse(text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    for node in document.descendants() {
        for attribute in node.attributes().filter(|a| !matches!(a.name(), "id" | "font-family")) {
            let value = attribute.value();
            assert!(!value.contains("NaN") && !value.contains("inf"), "{attribute:?}");
        }
        let name = node.tag_name().name();
        assert!(!matches!(name, "script" | "a" | "image" | "foreignObject" | "use"), "<{name}> in {text}");
        assert!(
            name != "text" || node.descendants().any(|n| n.text().is_some_and(|t| !t.is_empty())),
            "a text of nothing"
        );
    }
}

/// A page for a student is well-formed once its few empty elements are closed; there are no scripts, and styles are those of the template alone.
pub fn html(text: &str) {
    terminal(text.as_bytes());
    let mut xml = String::with_capacity(text.len());
    let mut rest =
        text.trim_start().strip_prefix("<!DOCTYPE html>").or(text.strip_prefix("<!doctype html>")).expect("a page");
    while let Some(start) = rest.find('<') {
        let (before, tag) = rest.split_at(start);
        xml.push_str(before);
        let end = tag.find('>').expect("every tag ends");
        let name: String = tag[1..].chars().take_while(char::is_ascii_alphanumeric).collect();
        match name.as_str() {
            "meta" | "input" | "link" | "br" => {
                xml.push_str(&format!("<{name}/>"));
                rest = &tag[end + 1..];
            }
            "script" | "style" => {
                assert_eq!(name, "style", "a script in {text}");
                let close = format!("</{name}>");
                let after = tag.find(&close).expect("it is closed") + close.len();
                rest = &tag[after..];
            }
            "svg" => {
                let after = tag.find("</svg>").expect("it is closed") + "</svg>".len();
                xml.push_str(&tag[..after].replacen(" hidden aria", " aria", 1));
                rest = &tag[after..];
            }
            _ => {
                // Attributes without a value, of which the template has these.
                xml.push_str(&tag[..=end].replace(" hidden>", ">").replace(" selected>", ">"));
                rest = &tag[end + 1..];
            }
        }
    }
    if let Err(error) = Document::parse(&xml) {
        panic!("{error}\n{xml}");
    }
}

/// A workbench is the page as it was built, and one element with a scene in plain letters. Its text.
pub fn workbench(text: &str) -> String {
    let mark = "<script type=\"application/json\" id=\"kinegon-scene\">";
    let (before, rest) = text.split_once(mark).expect("a scene");
    let (data, after) = rest.split_once("</script>\n").expect("its end");
    let built = include_str!("../../templates/workbench.html");
    assert!(built.strip_prefix(before) == Some(after), "the page itself has changed");
    assert!(after.starts_with("</head>") && data.bytes().all(|b| matches!(b, b' '..=b'~') && b != b'<'), "{data}");
    json(data)["text"].as_str().expect("a text").to_owned()
}

/// A PDF has pages whose contents can be decoded, and metadata without control characters.
pub fn pdf(bytes: &[u8]) {
    let pdf = Pdf::load_mem(bytes).expect("it is PDF");
    let pages = pdf.get_pages();
    assert!(!pages.is_empty());
    for page in pages.values() {
        let content = pdf.get_and_decode_page_content(*page).expect("its content can be read");
        for operation in content.operations {
            for number in operation.operands.iter().filter_map(|operand| operand.as_float().ok()) {
                assert!(number.is_finite(), "{operation:?}");
            }
        }
    }
    let metadata = pdf.objects.values().filter_map(|object| object.as_stream().ok());
    for stream in metadata.filter(|s| s.dict.get(b"Type").is_ok_and(|t| t.as_name().is_ok_and(|n| n == b"Metadata"))) {
        let xmp = String::from_utf8(stream.get_plain_content().unwrap_or(stream.content.clone())).expect("UTF-8");
        let start = xmp.find("<x:xmpmeta").expect("XMP");
        let end = xmp.find("</x:xmpmeta>").expect("XMP ends") + "</x:xmpmeta>".len();
        assert!(Document::parse(&xmp[start..end]).is_ok(), "{xmp}");
    }
}

/// In a picture for LaTeX braces and dollars are balanced, and no sign with a meaning stands in a text.
pub fn tex(text: &str) {
    terminal(text.as_bytes());
    let body = text.find("\\begin{tikzpicture}").expect("a picture");
    let (mut depth, mut in_formula, mut escaped, mut in_comment) = (0_i32, false, false, false);
    for (at, c) in text.char_indices() {
        if in_comment {
            in_comment = c != '\n';
            continue;
        }
        if escaped {
            escaped = false;
            continue;
        }
        let in_body = at > body;
        match c {
            '\\' => escaped = true,
            '%' => in_comment = true,
            '{' => depth += 1,
            '}' => depth -= 1,
            '$' => in_formula = !in_formula,
            '#' | '&' | '~' if in_body => panic!("a bare {c} in {}", around(text, at)),
            '_' | '^' if in_body => assert!(in_formula, "a bare {c} in {}", around(text, at)),
            '\n' => assert!(!in_formula, "a formula goes on in {}", around(text, at)),
            _ => {}
        }
        assert!(depth >= 0, "a brace too many in {}", around(text, at));
    }
    assert!(depth == 0 && !in_formula, "{depth} braces are open");
    let commands =
        text[body..].split('\\').skip(1).map(|c| c.chars().take_while(char::is_ascii_alphabetic).collect::<String>());
    for command in commands {
        let bad =
            ["input", "write", "def", "openout", "include", "immediate", "catcode", "csname", "usepackage", "read"];
        assert!(!bad.contains(&command.as_str()), "\\{command}");
    }
    assert_eq!(text.matches("\\end{tikzpicture}").count(), 1);
}

fn around(text: &str, at: usize) -> String {
    let before: String = text[..at].chars().rev().take(60).collect::<Vec<_>>().into_iter().rev().collect();
    before + &text[at..].chars().take(60).collect::<String>()
}

/// JSON that a terminal can show.
pub fn json(text: &str) -> serde_json::Value {
    terminal(text.as_bytes());
    serde_json::from_str(text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// A table whose rows are as wide as its head, and none of whose cells is a formula, whatever separates them.
pub fn csv(text: &str) {
    terminal(text.as_bytes());
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let rows: Vec<csv::StringRecord> = reader.records().map(|row| row.expect("a row as wide as its head")).collect();
    for row in &rows {
        row.iter().for_each(no_formula);
    }
    // Opened where a semicolon or a tab separates cells.
    for line in text.lines() {
        // Of a number with what follows behind commas the number counts.
        let number = |cell: &&str| cell.split(',').next().is_none_or(|first| first.trim().parse::<f64>().is_err());
        line.split([';', '\t']).filter(number).for_each(no_formula);
    }
}

/// OWASP's rule: no cell begins with a sign that begins a formula, unless it is a number.
fn no_formula(cell: &str) {
    let invisible = |c: char| {
        c.is_whitespace()
            || matches!(u32::from(c), 0xad | 0x200b..=0x200d | 0x2060..=0x2064 | 0xfeff | 0x180e | 0xfe00..=0xfe0f)
    };
    let shown = cell.trim_start_matches(invisible).trim_start_matches('"').trim_start_matches(invisible);
    let begins = shown.starts_with(['=', '+', '-', '@', '\u{ff1d}', '\u{ff0b}', '\u{ff0d}', '\u{ff20}']);
    assert!(!begins || cell.trim().parse::<f64>().is_ok(), "a formula: {cell:?}");
}
