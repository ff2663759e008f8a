//! The files of what was measured: a line of column names, and rows.

/// A comma-separated file, in which no field is quoted. Lines that begin with
/// `#` are remarks.
pub(super) struct Table<'a> {
    file: &'static str,
    columns: Vec<&'a str>,
    rows: Vec<(usize, Vec<&'a str>)>,
}

/// A row of a [`Table`].
#[derive(Clone, Copy)]
pub(super) struct Row<'a> {
    table: &'a Table<'a>,
    line: usize,
    fields: &'a [&'a str],
}

impl<'a> Table<'a> {
    /// Reads `text`; `file` is what messages call it.
    pub(super) fn read(file: &'static str, text: &'a str) -> Result<Self, String> {
        let mut lines = text
            .lines()
            .zip(1..)
            .filter(|(line, _)| !line.starts_with('#') && !line.is_empty())
            .map(|(line, number)| (number, line.split(',').collect::<Vec<_>>()));
        let (_, columns) = lines.next().ok_or(format!("{file} is empty"))?;
        let rows: Vec<(usize, Vec<&str>)> = lines.collect();
        for (line, fields) in &rows {
            if fields.len() != columns.len() {
                return Err(format!(
                    "{file}, line {line}: {} fields under {} columns",
                    fields.len(),
                    columns.len()
                ));
            }
        }
        Ok(Self {
            file,
            columns,
            rows,
        })
    }

    /// All rows, from the top.
    pub(super) fn rows(&'a self) -> impl Iterator<Item = Row<'a>> {
        self.rows.iter().map(|(line, fields)| Row {
            table: self,
            line: *line,
            fields,
        })
    }
}

impl<'a> Row<'a> {
    /// The field in that column.
    pub(super) fn text(&self, column: &str) -> Result<&'a str, String> {
        let Table { file, columns, .. } = self.table;
        let place = columns.iter().position(|name| *name == column);
        let place = place.ok_or(format!("{file} has no column `{column}`"))?;
        Ok(self.fields[place])
    }

    /// The number in that column; NaN if nothing stands there.
    pub(super) fn number(&self, column: &str) -> Result<f64, String> {
        let text = self.text(column)?;
        if text.is_empty() {
            return Ok(f64::NAN);
        }
        text.parse().map_err(|_| {
            let (file, line) = (self.table.file, self.line);
            format!("{file}, line {line}: `{text}` in the column `{column}` is no number")
        })
    }
}
