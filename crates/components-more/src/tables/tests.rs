use katydid_component::Files;
use katydid_component::testing::Trial;
use katydid_data::Value;

/// A folder with a file in it.
fn folder(name: &str, bytes: &[u8]) -> (tempfile::TempDir, Files) {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join(name), bytes).unwrap();
    let files = Files::Inside(folder.path().to_path_buf());
    (folder, files)
}

/// The rows that are read of a file, and what is said.
fn read(name: &str, bytes: &[u8], sheet: Value) -> (Vec<String>, String) {
    let (_folder, files) = folder(name, bytes);
    let outcome = Trial::of("Spreadsheet Reader").item(name).item(sheet).files(files).run();
    let said = outcome.messages.first().map(|message| message.text.clone()).unwrap_or_default();
    (outcome.outputs.get(1).map(katydid_component::testing::texts).unwrap_or_default(), said)
}

#[test]
fn signs_between_cells_are_found() {
    let one = Value::Integer(1);
    assert_eq!(read("a.csv", b"a;b\n1,5;2\n", one.clone()).0, ["{0}: a, b", "{1}: 1,5, 2"]);
    assert_eq!(read("a.csv", b"a;b\n1.5;2\n", one.clone()).0, ["{0}: a, b", "{1}: 1.5, 2"]);
    assert_eq!(read("a.csv", b"\xef\xbb\xbfa\tb\n\"x\ty\"\t\n", one.clone()).0, ["{0}: a, b", "{1}: x\ty,"]);
    assert_eq!(read("a.csv", b"", one.clone()).0, Vec::<String>::new());
    assert!(read("a.doc", b"text", one).1.contains("is no spreadsheet"));
}

#[test]
fn one_long_row_makes_no_table_without_end() {
    let mut text = ",".repeat(30_000);
    text.push_str(&"\n1".repeat(30_000));
    let (rows, said) = read("a.csv", text.as_bytes(), Value::Integer(1));
    assert_eq!(said, "a.csv: it cannot be read: 30001 rows of 30001 cells are too many");
    assert_eq!(rows, Vec::<String>::new());
}

#[test]
fn cells_of_text_files_are_what_they_look_like() {
    let (_folder, files) = folder("a.csv", b"1.50,inf,true,-,1e3,,007x\n");
    let table = Trial::of("Excel Reader").default().item("a.csv").default().files(files).run();
    let kinds: Vec<Option<Value>> = table.outputs[1].column().iter().collect();
    assert_eq!(
        kinds,
        [
            Some(Value::Number(1.5)),
            Some(Value::text("inf")),
            Some(Value::Boolean(true)),
            Some(Value::text("-")),
            Some(Value::Number(1000.0)),
            None,
            Some(Value::text("007x")),
        ]
    );
}

#[cfg(feature = "spreadsheets")]
mod excel {
    use std::sync::Arc;

    use katydid_component::Outbox;
    use katydid_data::{DateTime, Path, Tree, TreeBuilder};

    use super::*;

    /// An .xlsx file of two sheets, as the writer makes it.
    fn workbook() -> Vec<u8> {
        let outbox = Arc::new(Outbox::default());
        let mut first = TreeBuilder::<Value>::new();
        let noon = DateTime::on([2026, 11, 27]).unwrap().ticks + DateTime::DAY / 2;
        first.branch(Path::from([0]));
        let items = [Value::text("name"), Value::Number(0.1), Value::Boolean(true)];
        items.into_iter().for_each(|item| first.push(Some(item)));
        first.branch(Path::from([4]));
        first.push(None);
        first.push(Some(Value::Time(DateTime { ticks: noon })));
        first.push(Some(Value::Integer(-7)));
        let second = Tree::item(Value::text("elsewhere"));
        let outcome = Trial::of("Spreadsheet Writer")
            .item("a.xlsx")
            .tree(first.finish())
            .tree(second)
            .names(["P", "Data", "Rest"])
            .outbox(&outbox)
            .run();
        assert!(outcome.messages.is_empty(), "{:?}", outcome.messages);
        outbox.take().swap_remove(0).bytes
    }

    #[test]
    fn what_one_library_writes_the_other_reads() {
        let bytes = workbook();
        assert_eq!(bytes, workbook(), "the same bytes each time");
        let (rows, said) = read("a.xlsx", &bytes, Value::Integer(1));
        assert_eq!(said, "");
        assert_eq!(rows.len(), 2);
        assert_eq!(rows[0], "{0}: name, 0.1, True");
        assert!(rows[1].starts_with("{1}: , ") && rows[1].ends_with(", -7"), "{}", rows[1]);
        assert!(rows[1].contains("2026"), "{}", rows[1]);
        assert_eq!(read("a.xlsx", &bytes, Value::Integer(2)).0, ["{0}: elsewhere"]);
        let (_folder, files) = folder("a.xlsx", &bytes);
        let named = Trial::of("Excel Reader").default().item("a.xlsx").item("REST").files(files).texts(1);
        assert_eq!(named, ["{0}: elsewhere"]);
    }

    #[test]
    fn moments_keep_their_second() {
        let (_folder, files) = folder("a.xlsx", &workbook());
        let outcome = Trial::of("Excel Reader").default().item("a.xlsx").default().files(files).run();
        let column = outcome.outputs[1].column();
        let moment = (0..column.len()).find_map(|at| match column.get(at) {
            Some(Value::Time(moment)) => Some(moment),
            _ => None,
        });
        let moment = moment.unwrap();
        assert_eq!(moment.date(), [2026, 11, 27]);
        assert_eq!(moment.time_of_day(), DateTime::DAY / 2);
    }

    #[test]
    fn sheets_that_are_not_there_are_named() {
        let bytes = workbook();
        let said = read("a.xlsx", &bytes, Value::Integer(3)).1;
        assert_eq!(said, "a.xlsx: The file has no sheet 3: its sheets are Data, Rest");
        assert!(read("a.xlsx", &bytes, Value::Integer(-1)).1.contains("no sheet -1"));
    }

    #[test]
    fn broken_files_are_refused() {
        let bytes = workbook();
        for length in (0..bytes.len()).step_by(97) {
            let (rows, said) = read("a.xlsx", &bytes[..length], Value::Integer(1));
            assert!(rows.is_empty() && !said.is_empty(), "{length}");
        }
        for at in (0..bytes.len()).step_by(53) {
            let mut wrong = bytes.clone();
            wrong[at] ^= 0x55;
            // Whatever is read, nothing panics: the solver would say so.
            let _ = read("a.xlsx", &wrong, Value::Integer(1));
        }
        assert!(
            read("a.xls", &[0xd0, 0xcf, 0x11, 0xe0, 1, 2, 3], Value::Integer(1)).1.contains("cannot be read")
        );
    }

    #[test]
    fn a_cell_far_out_does_not_make_a_table_of_all_before_it() {
        let mut book = rust_xlsxwriter::Workbook::new();
        book.add_worksheet().write_number(1_048_575, 16_383, 1.0).unwrap();
        let said = read("a.xlsx", &book.save_to_buffer().unwrap(), Value::Integer(1)).1;
        assert!(said.contains("are too many"), "{said}");
    }

    /// An archive with one file of so many zeros.
    fn bomb(megabytes: usize) -> Vec<u8> {
        use std::io::Write;
        let mut writer = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
        let options = zip::write::SimpleFileOptions::default();
        writer.start_file("xl/sharedStrings.xml", options).unwrap();
        let block = vec![0_u8; 1 << 20];
        (0..megabytes).for_each(|_| writer.write_all(&block).unwrap());
        writer.finish().unwrap().into_inner()
    }

    #[test]
    fn files_that_unpack_without_end_are_refused() {
        let said = read("a.xlsx", &bomb(300), Value::Integer(1)).1;
        assert!(said.contains("unpacked, it is too large"), "{said}");
    }
}
