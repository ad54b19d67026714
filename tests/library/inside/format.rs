//! Files: SVG, PNG, pages, and how their numbers are written.

mod digits {
    use kinegon::format::digits::{Certain, certain};

    #[test]
    fn the_last_digit_is_right_to_one_unit() {
        for (value, bound, text) in [
            (1.23456789, 0.0004, "1.235"),
            (1.23456789, 0.0006, "1.23"),
            (-0.00860783887219, 7.5e-16, "-0.00860783887219"),
            (0.99999, 0.0005, "1.000"),
            (123456.0, 400.0, "1.23e5"),
            (123456.0, 0.4, "123456"),
            (3.0, 0.4, "3"),
            (2.5, 0.0, "2.5"),
            (0.0, 0.0, "0"),
            (1e-9, 1e-12, "1.00e-9"),
            (1.0, 1e-300, "1.0000000000000000"),
        ] {
            let digits = Certain::Digits(text.to_owned());
            assert_eq!(certain(value, bound), digits, "{value} {bound}");
        }
        for (value, bound, within) in
            [(0.0, 3e-17, "3e-17"), (2e-17, 1e-17, "3e-17"), (7.0, 4.0, "2e1"), (1.0, 9.5, "2e1"), (-4.0, 5.0, "9e0")]
        {
            let none = Certain::None(within.to_owned());
            assert_eq!(certain(value, bound), none, "{value} {bound}");
        }
    }
}

mod number {
    use kinegon::format::number::number;

    #[test]
    fn numbers_are_short_and_rounded_to_a_micrometre() {
        let cases = [
            (0.0, "0"),
            (-0.0, "0"),
            (-0.0004, "0"),
            (0.0005, "0.001"),
            (1.0, "1"),
            (-1.5, "-1.5"),
            (12.3456, "12.346"),
            (0.05, "0.05"),
            (0.1 + 0.2, "0.3"),
            (210.0, "210"),
            (-0.001, "-0.001"),
            (1.02, "1.02"),
            (f64::NAN, "0"),
            (1e6, "1000000"),
        ];
        for (value, text) in cases {
            assert_eq!(number(value), text);
        }
        assert_eq!(number(f64::INFINITY), "9223372036854775.807");
    }
}

mod png {
    use kinegon::drawing::{Drawing, Pen, PlacedText, Point, RichText, Shape};
    use kinegon::format::PngError;

    fn sheet() -> Drawing {
        let mut drawing = Drawing::new(101.6, 50.8);
        drawing.draw(Pen::Link, Shape::Line(Point::new(0.0, 25.4), Point::new(101.6, 25.4)));
        drawing.draw(Pen::Label, Shape::Text(PlacedText::new(RichText::math("S_3"), 8.0, Point::new(40.0, 15.0))));
        drawing
    }

    #[test]
    fn pixels_and_resolution_follow_the_sheet() {
        let file = sheet().png(150.0).expect("a picture");
        let mut reader = png::Decoder::new(std::io::Cursor::new(&file)).read_info().expect("a picture");
        let info = reader.info();
        assert_eq!((info.width, info.height, info.color_type), (600, 300, png::ColorType::Rgb));
        let size = info.pixel_dims.expect("a picture");
        assert_eq!((size.xppu, size.yppu, size.unit), (5906, 5906, png::Unit::Meter));
        let mut pixels = vec![0; reader.output_buffer_size().expect("a picture")];
        reader.next_frame(&mut pixels).expect("a picture");
        let pixel = |x: usize, y: usize| &pixels[3 * (600 * y + x)..][..3];
        assert_eq!(pixel(5, 5), [255, 255, 255]);
        assert_eq!(pixel(300, 150), [0x1a, 0x1a, 0x1a]);
        // Ink of the label, from the bundled font.
        let dark =
            (60..95).flat_map(|y| (230..275).map(move |x| (x, y))).filter(|&(x, y)| pixel(x, y)[0] < 128).count();
        assert!(dark > 50, "{dark} dark pixels");
    }

    #[test]
    fn impossible_pictures_are_refused() {
        let sheet = sheet();
        assert!(matches!(sheet.png(6000.0), Err(PngError::TooLarge { width: 24000.0, .. })));
        assert!(
            sheet
                .png(6000.0)
                .expect_err("too large")
                .to_string()
                .contains("24000 x 12000 pixels; a side may have 20000")
        );
        for dpi in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(matches!(sheet.png(dpi), Err(PngError::Resolution { .. })));
        }
        let nowhere = Drawing::new(f64::NAN, 10.0);
        assert!(matches!(nowhere.png(96.0), Err(PngError::Svg(_))));
    }
}

mod svg {
    use kinegon::drawing::{Drawing, Pen, PlacedText, Point, RichText, Shape};
    use kinegon::format::{Text, svg_with};

    #[test]
    fn hostile_texts_are_escaped() {
        let mut drawing = Drawing::new(10.0, 10.0);
        drawing.title = "a < b & \"c\" \u{1}".into();
        let text = PlacedText::new(RichText::verbatim("<tspan>&\u{0}"), 4.0, Point::new(1.0, 5.0));
        drawing.draw_named("x\"><script>", Pen::Label, Shape::Text(text));
        let file = drawing.svg();
        assert!(file.contains("<title>a &lt; b &amp; &quot;c&quot; </title>"), "{file}");
        assert!(file.contains("&lt;tspan&gt;&amp;</text>"), "{file}");
        assert!(file.contains("id=\"x&quot;&gt;&lt;script&gt;\""), "{file}");
        assert!(!file.contains('\u{0}') && !file.contains('\u{1}'));
    }

    #[test]
    fn outlines_need_no_font() {
        let mut drawing = Drawing::new(60.0, 30.0);
        let line = Shape::Line(Point::new(0.0, 10.0), Point::new(60.0, 10.0));
        drawing.draw(Pen::Link, line);
        let text = PlacedText::new(RichText::math("S_3"), 4.0, Point::new(5.0, 11.0));
        drawing.draw_named("label-S3", Pen::Label, Shape::Text(text));
        let text = PlacedText::new(RichText::verbatim("l漢"), 4.0, Point::new(30.0, 25.0));
        drawing.draw(Pen::Caption, Shape::Text(text));
        let file = svg_with(&drawing, Text::Outlines);
        assert!(!file.contains("<text") && !file.contains("font"), "{file}");
        assert!(file.contains("<path id=\"label-S3\" d=\"m"), "{file}");
        // Halo and letters are the same outlines.
        let data = |from: &str| {
            let rest = &file[file.find(from).expect("it is there") + from.len()..];
            rest[..rest.find('"').expect("it ends")].to_owned()
        };
        let halo = "aria-hidden=\"true\">\n<path d=\"";
        assert_eq!(data(halo), data("id=\"label-S3\" d=\""));
        assert!(file.contains("stroke-width=\"60\" transform=\"scale(.01)\""));
        // A letter that the font lacks is an empty box: a path inside another.
        assert!(file.contains("m92-215l192 0 0 264-192 0zm20 244l152 0 0-224-152 0z"), "{file}");
    }

    #[test]
    fn marks_that_are_not_finite_are_left_out() {
        let mut drawing = Drawing::new(10.0, 10.0);
        drawing.draw(Pen::Link, Shape::Line(Point::new(f64::NAN, 0.0), Point::new(1.0, 1.0)));
        drawing.draw(Pen::Link, Shape::Circle { center: Point::ORIGIN, radius: f64::INFINITY });
        let file = drawing.svg();
        assert!(!file.contains("<path") && !file.contains("<circle"));
    }

    #[test]
    fn empty_texts_are_left_out() {
        let mut drawing = Drawing::new(10.0, 10.0);
        let empty = PlacedText::new(RichText::plain(""), 4.0, Point::new(1.0, 5.0));
        drawing.draw(Pen::Caption, Shape::Text(empty));
        assert!(!drawing.svg().contains("<text"));
    }

    #[test]
    fn arrows_are_one_named_group() {
        let mut drawing = Drawing::new(50.0, 50.0);
        drawing.draw_named(
            "vector-v",
            Pen::Velocity,
            Shape::Arrow { from: Point::new(0.0, 10.0), to: Point::new(20.0, 10.0), head: 2.6 },
        );
        let file = drawing.svg();
        let arrow = "<g id=\"vector-v\"><path d=\"M0 10L18.18 10\"/><path fill=\"#0b4f8a\" stroke=\"none\" \
                     d=\"M20 10L17.4 10.442L17.816 10L17.4 9.558Z\"/></g>";
        assert!(file.contains(arrow), "{file}");
    }

    #[test]
    fn a_full_turn_is_drawn() {
        let mut drawing = Drawing::new(10.0, 10.0);
        let turn = Shape::Arc { center: Point::new(5.0, 5.0), radius: 2.0, start: 0.0, sweep: std::f64::consts::TAU };
        drawing.draw(Pen::Link, turn);
        let file = drawing.svg();
        assert!(file.contains("M7 5A2 2 0 0 1 4 6.732A2 2 0 0 1 4 3.268A2 2 0 0 1 7 5"), "{file}");
    }
}

mod workbench {
    use kinegon::format::{OpenScene, workbench};
    use serde_json::{Value, json};

    const PAGE: &str = include_str!("../../../templates/workbench.html");

    #[test]
    fn a_scene_stands_in_the_head_and_cannot_leave_it() {
        let text = "{\"title\": \"</script><script>alert(1)</script><!-- \u{1b}[31m \u{202e} ω 𝄞 \\u003c\"}\r\n";
        let page = workbench(Some(OpenScene { text, step: Some(7) }));
        let mark = "<script type=\"application/json\" id=\"kinegon-scene\">";
        let (before, rest) = page.split_once(mark).expect("it is there");
        let (data, after) = rest.split_once("</script>\n").expect("its end");
        assert_eq!(format!("{before}{after}"), PAGE);
        assert!(after.starts_with("</head>"));
        let read: Value = serde_json::from_str(data).expect("JSON");
        assert_eq!(read, json!({ "text": text, "step": 7 }));
        assert!(data.bytes().all(|b| matches!(b, b' '..=b'~')) && !data.contains('<'));
        assert_eq!(workbench(None), PAGE);
    }
}
