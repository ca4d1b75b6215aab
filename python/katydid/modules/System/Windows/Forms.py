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


__getattr__ = _missing(__name__)
