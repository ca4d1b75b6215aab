"""System.Windows.Forms: a message box becomes a remark on the component; windows are not here."""

from katydid.rhino import missing as _missing
from katydid.run.component import remark as _remark


class DialogResult:
    NONE, OK, Cancel, Abort, Retry, Ignore, Yes, No = 0, 1, 2, 3, 4, 5, 6, 7


class MessageBox:
    @staticmethod
    def Show(text="", *caption_and_buttons):
        _remark(str(text))
        return DialogResult.OK


class _Item:
    """What scripts add to a component's menu: there is no menu, so it is never shown."""

    def __init__(self, *arguments, **keywords):
        self.Text = str(arguments[0]) if arguments else ""
        self.Checked = self.Enabled = True
        self.Click = _Handlers()
        self.DropDownItems = self.Items = _Items()


class _Handlers:
    """An event that nothing raises."""

    def __iadd__(self, handler):
        return self

    __isub__ = __iadd__


class _Items(list):
    def Add(self, item, *rest):
        self.append(item)
        return item


class ToolStripMenuItem(_Item):
    pass


class ToolStripSeparator(_Item):
    pass


class ToolStripDropDown(_Item):
    pass


class ToolStripDropDownMenu(_Item):
    pass


__getattr__ = _missing(__name__)
