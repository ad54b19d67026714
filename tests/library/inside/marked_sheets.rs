//! Markers and the code on a sheet that is photographed.

mod markers {
    use kinegon::drawing::Rect;
    use kinegon::drawing::markers::{CODES, cells, code_place, places};

    /// A code turned by a right angle clockwise.
    fn turned(code: u16) -> u16 {
        let bit = |row: usize, column: usize| code >> (15 - (4 * row + column)) & 1;
        (0..16).fold(0, |turned, place| turned << 1 | bit(3 - place % 4, place / 4))
    }

    fn turns(code: u16) -> [u16; 4] {
        let mut turns = [code; 4];
        for k in 1..4 {
            turns[k] = turned(turns[k - 1]);
        }
        assert_eq!(turned(turns[3]), code);
        turns
    }

    #[test]
    fn codes_differ_however_they_are_turned() {
        for (i, code) in CODES.into_iter().enumerate() {
            for (j, other) in CODES.into_iter().enumerate() {
                for (quarter, turned) in turns(other).into_iter().enumerate() {
                    let differing = (code ^ turned).count_ones();
                    let is_same = i == j && quarter == 0;
                    assert!(is_same || differing >= 6, "{code:#06x} and {other:#06x}, turned {quarter} times");
                }
            }
        }
    }

    #[test]
    fn cells_are_ring_and_code() {
        let drawn: Vec<String> =
            cells(0x01c7).iter().map(|row| row.iter().map(|black| if *black { '#' } else { '.' }).collect()).collect();
        assert_eq!(drawn, ["######", "#....#", "#...##", "###..#", "#.####", "######"]);
    }

    #[test]
    fn places_on_a4() {
        let places = places([297.0, 210.0]).map(|place| [place.x0, place.y0, place.x1, place.y1]);
        assert_eq!(places[0], [6.5, 6.5, 14.5, 14.5]);
        assert_eq!(places[1], [144.5, 6.5, 152.5, 14.5]);
        assert_eq!(places[3], [282.5, 101.0, 290.5, 109.0]);
        assert_eq!(places[4], [282.5, 195.5, 290.5, 203.5]);
        assert_eq!(places[7], [6.5, 101.0, 14.5, 109.0]);
        assert_eq!(code_place([297.0, 210.0]), Rect::new(263.5, 176.5, 279.5, 192.5));
        assert_eq!(code_place([297.0, 420.0]), Rect::new(259.5, 382.5, 279.5, 402.5));
    }
}

mod outlines {
    use kinegon::drawing::markers::{CODES, cells};
    use kinegon::drawing::markers::{Corner, outlines};

    /// Twice the signed area within chains, in cells; positive clockwise to the eye.
    fn doubled(chains: &[Vec<Corner>]) -> i64 {
        let cross = |a: Corner, b: Corner| a[0] as i64 * b[1] as i64 - b[0] as i64 * a[1] as i64;
        let chain = |chain: &Vec<Corner>| -> i64 {
            (0..chain.len()).map(|k| cross(chain[k], chain[(k + 1) % chain.len()])).sum()
        };
        chains.iter().map(chain).sum()
    }

    #[test]
    fn outlines_hold_the_black_cells() {
        for code in CODES {
            let cells = cells(code).map(|row| row.to_vec());
            // 20 cells of the ring and those of the code.
            assert_eq!(doubled(&outlines(&cells)), 2 * i64::from(20 + code.count_ones()), "{code:#06x}");
        }
        let ring = [[true, true, true], [true, false, true], [true, true, true]].map(|row| row.to_vec());
        let mut ring = outlines(&ring);
        ring.sort_by_key(|chain| chain[0]);
        assert_eq!(ring, [vec![[0, 0], [3, 0], [3, 3], [0, 3]], vec![[1, 1], [1, 2], [2, 2], [2, 1]]]);
        // Cells that touch at a corner.
        let diagonal = [[true, false], [false, true]].map(|row| row.to_vec());
        assert_eq!(doubled(&outlines(&diagonal)), 4);
    }
}

mod sheet_code {
    use kinegon::Sheet;
    use kinegon::drawing::markers::{PlacedPanel, SheetCode};
    use kinegon::scene::{Page, PageSize};

    fn code() -> SheetCode {
        let plan = |panel, mu, origin| PlacedPanel { panel, mu, origin };
        SheetCode {
            page: Page { size: PageSize::A4, landscape: true },
            number: 2,
            scene: "8K3MNQ4T".into(),
            panels: vec![plan(Sheet::Velocity, 0.05, [148.0, 105.0]), plan(Sheet::Acceleration, 0.5, [60.0, 90.25])],
            name: "FOUR-BAR-7-2".into(),
        }
    }

    #[test]
    fn texts_are_read_back() {
        let code = code();
        assert_eq!(code.text(), "K1/A4L/2/8K3MNQ4T/V0.05:148:105+A0.5:60:90.25/FOUR-BAR-7-2");
        assert_eq!(SheetCode::read(&code.text()), Some(code.clone()));
        for size in [PageSize::A4, PageSize::A3, PageSize::Letter] {
            for landscape in [true, false] {
                for mu in [1e-9, 2.5e-7, 0.1, 25.0, 5e30] {
                    let page = Page { size, landscape };
                    let panels = vec![PlacedPanel { panel: Sheet::Scheme, mu, origin: [-12_345.67, -0.5] }];
                    let code = SheetCode { page, panels, number: 65535, ..code.clone() };
                    assert_eq!(SheetCode::read(&code.text()), Some(code));
                }
            }
        }
    }

    #[test]
    fn names_and_places_are_written_in_few_signs() {
        let named = |name: &str| SheetCode { name: name.into(), ..code() }.text();
        assert!(named("Übung 7/a").ends_with("/-BUNG 7-A"), "{}", named("Übung 7/a"));
        assert!(named("").ends_with("/"));
        assert!(named(&"long ".repeat(10)).ends_with("/LONG LONG LONG LONG LONG"));
        let mut code = code();
        code.panels[0].origin = [-0.001, 12.345_678];
        assert!(code.text().contains("/V0.05:0:12.35+"), "{}", code.text());
    }

    #[test]
    fn other_texts_are_none() {
        let good = code().text();
        let changed = [
            ("K1", "K2"),
            ("A4L", "A5L"),
            ("A4L", "L"),
            ("/2/", "/0/"),
            ("/2/", "/+2/"),
            ("/2/", "/02/"),
            ("/2/", "/65536/"),
            ("8K3MNQ4T", "8K3MNQ4"),
            ("8K3MNQ4T", "8K3MNQ4Z"),
            ("8K3MNQ4T", "8K3MNQ4t"),
            ("V0.05", "V0"),
            ("V0.05", "V-1"),
            ("V0.05", "VNAN"),
            ("V0.05", "Vinf"),
            ("V0.05", "V1E999"),
            ("V0.05", "V1E-999"),
            ("V0.05", "V1E-101"),
            ("V0.05", "V"),
            ("V0.05", "ü0.05"),
            ("V0.05", "A0.05"),
            (":148:", ":1E101:"),
            (":148:", "::"),
            (":148:", ":148:1:"),
            (":148:", ":"),
            ("V0.05:148:105+", "V0.05:148:105++"),
            ("V0.05:148:105+A0.5:60:90.25", ""),
            ("FOUR", "four"),
            ("FOUR", "FÖUR"),
            ("FOUR", "FOUR/FOUR"),
            ("FOUR", "FOURFOURFOURFOURFOURFOUR"),
        ];
        for (part, other) in changed {
            assert!(good.contains(part));
            let text = good.replace(part, other);
            assert_eq!(SheetCode::read(&text), None, "{text}");
        }
        for text in ["", "/", "//////", "K1", "https://example.org/", "\u{0}", "K1/A4L/2/8K3MNQ4T/ü/X"] {
            assert_eq!(SheetCode::read(text), None);
        }
        assert_eq!(SheetCode::read(&"K1/".repeat(100_000)), None);
        // Any of its signs replaced or cut off: read or not, without a panic.
        for at in 0..good.len() {
            for other in ["", "ß", "/", "-", "E", "9", "\u{10ffff}"] {
                let _ = SheetCode::read(&format!("{}{other}{}", &good[..at], &good[at + 1..]));
            }
            let _ = SheetCode::read(&good[..at]);
        }
    }

    #[test]
    fn codes_have_few_modules() {
        // 61 letters fit into version 3 with medium correction (ISO/IEC 18004, table 7), whose side has 29 modules.
        let modules = code().modules().expect("a code");
        assert!(code().text().len() <= 61);
        assert_eq!([modules.len(), modules[0].len()], [29, 29]);
        // The finder pattern: a black ring of seven modules.
        assert!((0..7).all(|k| modules[0][k] && modules[k][0] && modules[6][k]) && !modules[1][1]);
        // A long one gives up correction: version 6 holds 154 letters with medium, 195 with low correction.
        let far = PlacedPanel { panel: Sheet::Scheme, mu: 1.234_567_890_123_4, origin: [-12_345_678.25; 2] };
        let panels =
            vec![far, PlacedPanel { panel: Sheet::Velocity, ..far }, PlacedPanel { panel: Sheet::Acceleration, ..far }];
        let long = SheetCode { panels, name: "N".repeat(24), ..code() };
        assert!((155..=195).contains(&long.text().len()), "{}", long.text());
        assert_eq!(long.modules().expect("a code").len(), 41);
        assert_eq!(SheetCode { scene: "ü".into(), ..code() }.modules(), None);
    }
}
