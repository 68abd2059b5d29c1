"""Arrays of every odd kind go in, and what a user expects comes out."""

import pickle
import threading
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import restitution

FUNCTIONS = [
    restitution.epsilon,
    restitution.loss,
    restitution.u_of_epsilon,
    restitution.duration,
    restitution.turning_time,
    restitution.largest_compression,
]


def pointwise(function, values):
    values = np.asarray(values, dtype=float)
    return np.array([function(float(x)) for x in values.ravel()]).reshape(values.shape)


@pytest.mark.parametrize("function", FUNCTIONS)
@pytest.mark.parametrize("shape", [(3,), (1,), (2, 3), (2, 0, 3), (0,), (1, 2, 3, 4)])
def test_any_shape(function, shape):
    x = np.linspace(0.05, 0.95, int(np.prod(shape))).reshape(shape)
    out = function(x)
    assert out.shape == shape and out.dtype == np.float64
    assert np.array_equal(out, pointwise(function, x))


@pytest.mark.parametrize("function", FUNCTIONS)
def test_any_stride(function):
    base = np.linspace(0.05, 0.95, 60).reshape(3, 4, 5)
    for x in (base[:, ::2], base[::-1], base.T, np.asfortranarray(base), base[..., 1], np.broadcast_to(0.5, (4, 4))):
        assert np.array_equal(function(x), pointwise(function, x))
    unaligned = np.frombuffer(b"\0" + base.tobytes(), dtype=np.uint8)[1:].view(np.float64)
    assert np.array_equal(function(unaligned), pointwise(function, unaligned))


def test_scalars_of_every_kind_give_floats():
    expected = restitution.epsilon(1.0)
    assert type(expected) is float
    for one in (1, True, np.float64(1), np.float32(1), np.int8(1), np.array(1.0), Fraction(1), Decimal(1)):
        assert restitution.epsilon(one) == expected, type(one)


def test_other_numbers_become_float64():
    for dtype in (np.float32, np.float16, np.int32, np.uint8, bool, object, ">f8", np.longdouble):
        x = np.array([0, 1], dtype=dtype)
        out = restitution.epsilon(x)
        assert out.dtype == np.float64 and np.array_equal(out, restitution.epsilon([0.0, 1.0])), dtype


def test_lists_tuples_ranges_and_nested():
    assert np.array_equal(restitution.epsilon((0, 1, 2)), restitution.epsilon(range(3)))
    assert restitution.epsilon([[0, 1], [2, 3]]).shape == (2, 2)
    assert restitution.epsilon([]).shape == (0,)


@pytest.mark.parametrize(
    "wrong", ["1.0", ["1"], np.array(["1.5"]), 1j, [1j], None, object(), {"u": 1}, np.array(["2000-01-01"], dtype="M8[D]")]
)
def test_what_is_no_number_is_refused(wrong):
    with pytest.raises((TypeError, ValueError)) as error:
        restitution.epsilon(wrong)
    assert "\n" not in str(error.value)


def test_ragged_lists_are_refused():
    with pytest.raises(ValueError):
        restitution.epsilon([[1, 2], [3]])


def test_nan_infinity_and_negative_numbers():
    out = restitution.epsilon([np.nan, -1.0, np.inf, 0.0, -0.0])
    assert np.isnan(out[:2]).all() and out[2] == 0 and (out[3:] == 1).all()


def test_masks_are_kept():
    x = np.ma.array([0.5, np.nan, 1.0], mask=[False, True, False])
    out = restitution.epsilon(x)
    assert isinstance(out, np.ma.MaskedArray) and out.mask.tolist() == [False, True, False]
    assert out[2] == restitution.epsilon(1.0)


def test_the_argument_is_neither_changed_nor_aliased():
    x = np.linspace(0, 8, 100)
    x.flags.writeable = False
    before = x.copy()
    out = restitution.epsilon(x)
    out[:] = 7
    assert np.array_equal(x, before)


def test_large_arrays_on_all_cores_have_the_same_numbers():
    x = np.linspace(0, 8, 100_001)
    assert np.array_equal(restitution.epsilon(x)[::1000], pointwise(restitution.epsilon, x[::1000]))


def test_threads_work_at_the_same_time():
    x = np.linspace(0, 8, 50_000)
    expected, results = restitution.epsilon(x), [None] * 8

    def work(k):
        results[k] = restitution.epsilon(x)

    threads = [threading.Thread(target=work, args=(k,)) for k in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(np.array_equal(result, expected) for result in results)


def test_pandas_keeps_its_labels():
    pandas = pytest.importorskip("pandas")
    series = pandas.Series([0.5, 1.0], index=["slow", "fast"], name="u")
    out = restitution.epsilon(series)
    assert isinstance(out, pandas.Series) and out["fast"] == restitution.epsilon(1.0) and out.name == "u"
    frame = pandas.DataFrame({"a": [0.5, 1.0], "b": [2.0, 3.0]})
    assert restitution.epsilon(frame).equals(frame.map(lambda u: restitution.epsilon(u)))


def test_dask_maps_blocks():
    dask = pytest.importorskip("dask.array")
    x = np.linspace(0, 8, 1000)
    blocks = dask.from_array(x, chunks=130)
    assert np.array_equal(dask.map_blocks(restitution.epsilon, blocks).compute(), restitution.epsilon(x))


def test_pickles():
    for curve in (
        restitution.Restitution.from_g_star("0.32cm/s", end="zero-force"),
        restitution.Restitution.from_material(
            young="9.4GPa", poisson=0.33, density=917, radius="2.75cm", dissipative_constant="1us", against="plane"
        ),
    ):
        back = pickle.loads(pickle.dumps(curve))
        assert back == curve and repr(back) == repr(curve) and back.epsilon(0.01) == curve.epsilon(0.01)
    digits = restitution.Certified("0.5", "1e-3")
    assert pickle.loads(pickle.dumps(digits)) == digits
    assert pickle.loads(pickle.dumps(restitution.epsilon)) is restitution.epsilon


def test_pint_quantities_are_converted():
    pint = pytest.importorskip("pint")
    unit = pint.UnitRegistry()
    curve = restitution.Restitution.from_g_star(0.32 * unit("cm/s"))
    assert curve.epsilon(1 * unit("cm/s")) == pytest.approx(curve.epsilon(0.01), rel=1e-14)
    several = curve.epsilon(np.array([1.0, 2.0]) * unit("mm/s"))
    assert several == pytest.approx(curve.epsilon([0.001, 0.002]), rel=1e-14)
    with pytest.raises(pint.DimensionalityError):
        curve.epsilon(1 * unit("m"))
