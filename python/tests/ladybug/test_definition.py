"""Ladybug's own components in a definition, run by `katydid run`: location, hour of the year, sun path, direct sun hours
and wind rose. What they give is compared with ladybug-core, called here.

The scripts come from the package that the test's environment has installed; the definition and the weather file are made
by the test. Nothing of Ladybug's is part of the project. Scripts read no files unless a folder is named
(docs/security.md): the weather file comes in as text, and the component that opens it says that it may not, or reads it.
"""

import base64
import json
import math
import os
import subprocess
import sys
import zlib

import corpus
import pytest
from hosts import program

ladybug_grasshopper = pytest.importorskip("ladybug_grasshopper", reason="ladybug-grasshopper is not installed")
pytestmark = pytest.mark.skipif(program() is None, reason="KATYDID names no program: Ladybug was not tested")

HOURS = range(5, 20)
#: A day in June, in hours of the year.
DAY = (31 + 28 + 31 + 30 + 31 + 20) * 24


def component(name, label, wires):
    """A user object of the package as a line of a definition: its script with all ports, and the wires to it."""
    path = os.path.join(os.path.dirname(ladybug_grasshopper.__file__), "user_objects", name + ".ghuser")
    with open(path, "rb") as file:
        script = corpus.read(corpus.read(file.read()).item("Object"))
    inputs, outputs = corpus._ports(script, "in"), corpus._ports(script, "out")
    # An input without a wire takes null, and is there: the scripts ask for all of their names.
    given = ", ".join("%s = %s" % (port["name"], wires.get(port["name"], "_")) for port in inputs)
    names = ", ".join(["out"] + [port["name"] for port in outputs if port["name"] != "out"])
    lines = ["%s = `GhPython Script` @%s(%s) variable -> %s {" % (label, corpus.GHPYTHON, given, names),
             "    CodeInput = %s" % json.dumps(script.item("CodeInput").replace("\r\n", "\n")), "    HideInput = true"]
    for k, port in enumerate(inputs):
        at = "    ParameterData/InputParam[%d]/" % k
        lines.append(at + "ScriptParamAccess = %d" % ("item", "list", "tree").index(port["access"]))
        lines.append(at + "TypeHintID = @%s" % port["hint"])
    return "\n".join(lines + ["}"])


#: Reads the weather file from the text that a panel holds.
READ = """
import base64, zlib
from ladybug.epw import EPW
epw = EPW.from_file_string(zlib.decompress(base64.b64decode(text)).decode('utf-8'))
place, speed, direction = epw.location.city, epw.wind_speed, epw.wind_direction
"""


@pytest.fixture(scope="module")
def weather(tmp_path_factory):
    """A weather file: wind from the east for a third of the year, from the south for the rest."""
    from ladybug.epw import EPW
    from ladybug.location import Location
    epw = EPW.from_missing_values()
    epw._location = Location("Test", "-", "-", 48.0, 11.0, 1.0, 500.0)
    epw.wind_speed.values = [2.0 + hour % 5 for hour in range(8760)]
    epw.wind_direction.values = [90.0 if hour % 3 == 0 else 180.0 for hour in range(8760)]
    path = str(tmp_path_factory.mktemp("ladybug") / "test.epw")
    epw.save(path)
    return path


@pytest.fixture(scope="module")
def results(weather):
    """What the definition gives, by output."""
    hours = ", ".join(str(DAY + hour) for hour in HOURS)
    with open(weather, "rb") as file:
        packed = base64.b64encode(zlib.compress(file.read(), 9)).decode("ascii")
    place = {"_latitude_": "48", "_longitude_": "11", "_time_zone_": "1", "_elevation_": "500"}
    parts = ["katydid 1", "units metres", "file = Panel(%s)" % json.dumps(packed),
             "epw = `GhPython Script` @%s(text = file) variable -> out, place, speed, direction {\n    CodeInput = %s\n}"
             % (corpus.GHPYTHON, json.dumps(READ)),
             component("LB Construct Location", "site", place),
             component("LB Calculate HOY", "hoy", {"_month_": "6", "_day_": "21", "_hour_": "0"}),
             "hours = Number([%s])" % hours,
             component("LB SunPath", "path", {"_location": "site.location", "hoys_": "hours"}),
             "box = Center Box(_, 1, 1.5, 2)",
             component("LB Direct Sun Hours", "sun", {"_vectors": "path.vectors", "_geometry": "box.B", "_grid_size": "1.0",
                                                      "_run": "true", "_cpu_count_": "1"}),
             component("LB Wind Rose", "rose", {"_data": "epw.speed", "_wind_direction": "epw.direction",
                                                "_dir_count_": "4"}),
             "hour of the year = Panel(hoy.hoy)", "place = Panel(epw.place)"]
    for output in ("path.altitudes", "path.azimuths", "sun.results", "rose.prevailing", "rose.angles", "rose.calm_hours"):
        parts.append("%s = Number(%s)" % (output.partition(".")[2].replace("_", " "), output))
    path = os.path.join(os.path.dirname(weather), "ladybug.kd")
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(parts) + "\n")
    run = subprocess.run([program(), "run", path, "--allow-scripts", "--python", sys.executable, "--json=values"],
                         stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, timeout=600)
    assert run.returncode == 0, run.stderr
    return json.loads(run.stdout)


def items(results, name):
    """The items of what a name shows, over all branches."""
    [shown] = [thing for thing in results["objects"] if thing["nickname"] == name]
    return [item for branch in shown["outputs"][0]["branches"] for item in branch["items"]]


def suns():
    """The suns of the day that stand above the horizon."""
    from ladybug.location import Location
    from ladybug.sunpath import Sunpath
    path = Sunpath.from_location(Location("-", "-", "-", 48.0, 11.0, 1.0, 500.0))
    found = [path.calculate_sun_from_hoy(DAY + hour) for hour in HOURS]
    return [sun for sun in found if sun.is_during_day]


def close(found, wanted):
    return len(found) == len(wanted) and all(math.isclose(a, b, rel_tol=1e-9, abs_tol=1e-9) for a, b in zip(found, wanted))


def test_hour_of_the_year_and_location(results):
    assert float(items(results, "hour of the year")[0]) == DAY
    assert items(results, "place") == ["Test"]


def test_the_sun_path(results):
    assert len(suns()) == 15
    assert close(items(results, "altitudes"), [sun.altitude for sun in suns()])
    assert close(items(results, "azimuths"), [sun.azimuth for sun in suns()])


def test_direct_sun_hours_of_a_box(results):
    """A box is convex: a side sees each sun that stands before it. Faces of one square metre on a box of 2 by 3 by 4."""
    toward = [sun.sun_vector_reversed for sun in suns()]
    wanted = []
    for count, (x, y, z) in ((12, (1, 0, 0)), (12, (-1, 0, 0)), (8, (0, 1, 0)), (8, (0, -1, 0)), (6, (0, 0, 1)),
                             (6, (0, 0, -1))):
        wanted += [sum(1 for v in toward if x * v.x + y * v.y + z * v.z > 0)] * count
    assert sorted(items(results, "results")) == sorted(wanted)


def test_the_wind_rose(results, weather):
    from ladybug.epw import EPW
    from ladybug.windrose import WindRose
    epw = EPW(weather)
    rose = WindRose(epw.wind_direction, epw.wind_speed, 4)
    # Two thirds of the hours come from the south.
    assert items(results, "prevailing") == [180.0] == [float(angle) for angle in rose.prevailing_direction]
    assert close(items(results, "angles"), [0.0, 90.0, 180.0, 270.0])
    assert items(results, "calm hours") == [0]


def test_a_weather_file_is_not_read_by_a_script(weather):
    path = os.path.join(os.path.dirname(weather), "read.kd")
    with open(path, "w", encoding="utf-8") as file:
        file.write("katydid 1\nfile = Panel(%s)\n%s\n" % (json.dumps(weather),
                                                         component("LB Import EPW", "epw", {"_epw_file": "file"})))
    run = subprocess.run([program(), "run", path, "--allow-scripts", "--python", sys.executable],
                         stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, timeout=600)
    assert run.returncode == 1 and "a script may not read the file" in run.stderr


def test_a_weather_file_in_a_named_folder_is_read(weather):
    """LB Import EPW opens it; its location and its wind are those that ladybug-core reads."""
    from ladybug.epw import EPW
    folder = os.path.dirname(weather)
    path = os.path.join(folder, "named.kd")
    reads = "wind = `GhPython Script` @%s(data = epw.wind_speed, place = epw.location) variable -> out, speed, city {\n" \
            "    CodeInput = %s\n}" % (corpus.GHPYTHON, json.dumps("speed = list(data.values)\ncity = place.city"))
    with open(path, "w", encoding="utf-8") as file:
        file.write("katydid 1\nfile = Panel(%s)\n%s\n%s\nplace = Panel(wind.city)\nspeed = Number(wind.speed)\n"
                   "shown = Panel(epw.location)\n"
                   % (json.dumps(weather), component("LB Import EPW", "epw", {"_epw_file": "file"}), reads))
    run = subprocess.run([program(), "run", path, "--allow-scripts", "--script-read", folder, "--python", sys.executable,
                          "--json=values"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, timeout=600)
    assert run.returncode == 0, run.stderr
    results, epw = json.loads(run.stdout), EPW(weather)
    assert items(results, "place") == ["Test"]
    assert close(items(results, "speed"), list(epw.wind_speed.values))
    # A panel shows the location as Python writes it.
    assert "\n".join(items(results, "shown")) == str(epw.location)
