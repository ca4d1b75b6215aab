"""Groups of objects, by name. They live in the document: a solve begins without any."""

import scriptcontext

from .coerce import coerceguidlist, coercerhinoobject
from .support import is_many


def _groups():
    """The groups of the document: Guids by name, in the order in which they were made."""
    return scriptcontext.doc._groups


def _named(group_name):
    found = _groups().get(str(group_name))
    if found is None:
        raise ValueError("there is no group %s" % group_name)
    return found


def AddGroup(group_name=None):
    """The name of a new group; None where there is one of that name."""
    groups = _groups()
    if group_name is None:
        number = len(groups) + 1
        while "Group%02d" % number in groups:
            number += 1
        group_name = "Group%02d" % number
    if not group_name or str(group_name) in groups:
        return None
    groups[str(group_name)] = []
    return str(group_name)


def AddObjectsToGroup(object_ids, group_name):
    """How many objects were added."""
    members, count = _named(group_name), 0
    for guid in coerceguidlist(object_ids, True):
        if guid not in members:
            members.append(guid)
            count += 1
    return count


def AddObjectToGroup(object_id, group_name):
    return AddObjectsToGroup([object_id], group_name) == 1


def DeleteGroup(group_name):
    """Forgets a group; its objects stay."""
    return _groups().pop(str(group_name), None) is not None


def RenameGroup(old_name, new_name):
    groups = _groups()
    if str(old_name) not in groups or not new_name or str(new_name) in groups:
        return None
    for name in list(groups):
        # In its old place.
        groups[str(new_name) if name == str(old_name) else name] = groups.pop(name)
    return str(new_name)


def GroupCount():
    return len(_groups())


def GroupNames():
    return list(_groups()) or None


def IsGroup(group_name):
    return str(group_name) in _groups()


def IsGroupEmpty(group_name):
    return not _named(group_name)


def ObjectsByGroup(group_name, select=False):
    return [guid for guid in _named(group_name) if scriptcontext.doc.Objects.Find(guid) is not None]


def ObjectGroups(object_id):
    """The names of the groups that an object is in."""
    guid = coercerhinoobject(object_id, True).Id
    return [name for name, members in _groups().items() if guid in members]


def ObjectTopGroup(object_id):
    """The group that was made last of those that an object is in."""
    names = ObjectGroups(object_id)
    return names[-1] if names else None


def IsObjectInGroup(object_id, group_name=None):
    names = ObjectGroups(object_id)
    return bool(names) if group_name is None else str(group_name) in names


def RemoveObjectsFromGroup(object_ids, group_name):
    """How many objects were taken out."""
    members, count = _named(group_name), 0
    for guid in coerceguidlist(object_ids, True):
        if guid in members:
            members.remove(guid)
            count += 1
    return count


def RemoveObjectFromGroup(object_id, group_name):
    return RemoveObjectsFromGroup([object_id], group_name) == 1


def RemoveObjectFromTopGroup(object_id):
    top = ObjectTopGroup(object_id)
    return top is not None and RemoveObjectFromGroup(object_id, top)


def RemoveObjectFromAllGroups(object_id):
    names = ObjectGroups(object_id)
    for name in names:
        RemoveObjectsFromGroup(object_id if is_many(object_id) else [object_id], name)
    return bool(names)
