import pytest


@pytest.fixture(autouse=True)
def _doctest_names(doctest_namespace):
    import numpy

    doctest_namespace["np"] = numpy
