"""Rows of a study as columns."""

from collections.abc import Mapping


class Table(Mapping):
    """Rows of a study by columns: `table["Area"]`, or `table["in.height"]` and `table["out.Area"]`, as in table.parquet.

    A column is an array where all its cells are numbers, NaN where there is nothing; else a list. `status` says how each point
    came out, `reason` why it did not come out well, `ok` whether its results can be used.
    """

    def __init__(self, inputs, outputs, columns):
        given, made, self.status, self.reason = columns
        self._columns = {"in." + name: column for name, column in zip(inputs, given)}
        self._columns.update(("out." + name, column) for name, column in zip(outputs, made))
        self._columns.update(status=self.status, reason=self.reason)

    @property
    def rows(self):
        """How many rows there are."""
        return len(self.status)

    @property
    def ok(self):
        """For each row whether its results can be used: its status is "ok" or "warning"."""
        return [status in ("ok", "warning") for status in self.status]

    def row(self, at):
        """A row as a dict."""
        return {name: column[at] for name, column in self._columns.items()}

    def __getitem__(self, name):
        for full in (name, "out." + name, "in." + name):
            if full in self._columns:
                return self._columns[full]
        raise KeyError("%s: the columns are %s" % (name, ", ".join(self._columns)))

    def __iter__(self):
        return iter(self._columns)

    def __len__(self):
        return len(self._columns)

    def to_pandas(self):
        """A pandas DataFrame, where pandas is installed."""
        import pandas
        return pandas.DataFrame(self._columns)

    def __repr__(self):
        return "<Table of %d rows: %s>" % (self.rows, ", ".join(self._columns))
