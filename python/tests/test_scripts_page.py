"""docs/scripts.md lists the members that are there, and no others."""

import pytest
import scripts_page
from hosts import program


@pytest.mark.skipif(program() is None, reason="KATYDID names no program: the page was not compared")
def test_the_page_is_up_to_date():
    with open(scripts_page.PAGE, encoding="utf-8") as page:
        written = page.read().partition(scripts_page.MARK)[2]
    assert written == scripts_page.tables(), "make it anew: python python/tests/scripts_page.py --write"
