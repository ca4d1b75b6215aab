"""Texts by key, on objects and in the document; sections of document data."""

import scriptcontext

from .coerce import coercerhinoobject


def _holder(object_id, on_geometry):
    """What holds the texts of an object: its attributes, or its geometry."""
    found = coercerhinoobject(object_id, True)
    if not on_geometry:
        return found.Attributes
    geometry = found.Geometry
    # What was added as a struct is geometry from now on.
    found.value = found._geometry = geometry
    return geometry


def GetUserText(object_id, key=None, attached_to_geometry=False):
    """The text of a key, or the keys where none is given."""
    holder = _holder(object_id, attached_to_geometry)
    return holder.GetUserString(key) if key else list(holder.GetUserStrings())


def SetUserText(object_id, key, value=None, attach_to_geometry=False):
    """Sets the text of a key; without a text the key goes."""
    holder = _holder(object_id, attach_to_geometry)
    if value is None:
        return holder.DeleteUserString(str(key))
    return holder.SetUserString(str(key), str(value))


def IsUserText(object_id):
    """0 without texts, 1 with some on the attributes, 2 with some on the geometry, 3 with both."""
    attributes, geometry = _holder(object_id, False), _holder(object_id, True)
    return (1 if list(attributes.GetUserStrings()) else 0) + (2 if list(geometry.GetUserStrings()) else 0)


def _strings():
    return scriptcontext.doc._strings


def SetDocumentUserText(key, value=None):
    """Sets the text of a key in the document; without a text the key goes."""
    if not key:
        return False
    if value is None:
        return _strings().pop(str(key), None) is not None
    _strings()[str(key)] = str(value)
    return True


def GetDocumentUserText(key=None):
    return _strings().get(str(key)) if key else [key for key in _strings() if isinstance(key, str)]


def DocumentUserTextCount():
    return len(GetDocumentUserText())


def IsDocumentUserText():
    return DocumentUserTextCount() > 0


def _data():
    """Entries by section and name: their keys are pairs."""
    return {key: value for key, value in _strings().items() if isinstance(key, tuple)}


def SetDocumentData(section, entry, value):
    """The value that was there before."""
    before = _strings().get((str(section), str(entry)))
    _strings()[str(section), str(entry)] = str(value)
    return before


def GetDocumentData(section=None, entry=None):
    """A value; the entries of a section; all sections."""
    if section is None:
        return sorted({key[0] for key in _data()})
    if entry is None:
        return [key[1] for key in _data() if key[0] == str(section)]
    return _data().get((str(section), str(entry)))


def DeleteDocumentData(section=None, entry=None):
    """Deletes an entry, a section, or all; whether something went."""
    gone = [key for key in _data() if (section is None or key[0] == str(section))
            and (entry is None or key[1] == str(entry))]
    for key in gone:
        del _strings()[key]
    return bool(gone)


def DocumentDataCount():
    return len(_data())


def IsDocumentData():
    return bool(_data())
