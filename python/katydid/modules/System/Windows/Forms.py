"""System.Windows.Forms: a message box becomes a remark on the component; windows are not here."""

from katydid.run.component import remark as _remark
from katydid.values.base import not_supported as _not_supported


class DialogResult:
    NONE, OK, Cancel, Abort, Retry, Ignore, Yes, No = 0, 1, 2, 3, 4, 5, 6, 7


class MessageBox:
    @staticmethod
    def Show(text="", *caption_and_buttons):
        _remark(str(text))
        return DialogResult.OK


def __getattr__(name):
    if name.startswith("_"):
        raise AttributeError(name)
    raise _not_supported("System.Windows.Forms." + name)
