"""Real use of the package: the same bytes as the command line, errors, Ctrl-C, arrays, data sets."""

import json
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import dapple

ROOT = Path(__file__).parents[2]
# The ellipses are dense: by default they are patches, which take fifty times as long on a model.
SPOTS = "meinhardt-spots"
PROGRAM = os.environ.get("DAPPLE", "dapple")


def spots(**more):
    marks = [dapple.ellipse([30 + 26 * k, 40 + 4 * k], [9, 6], angle=30) for k in range(3)]
    return dapple.document([128, 96], layers=[dapple.layer(marks)], **more)


@pytest.fixture(scope="module")
def grown():
    return dapple.grow(spots())


def test_arrays_have_the_documented_shapes_and_types(grown):
    assert grown.size == (128, 96)
    assert (grown.rgb.shape, grown.rgb.dtype) == ((96, 128, 3), np.uint8)
    assert (grown.rgba.shape, grown.rgba.dtype) == ((96, 128, 4), np.uint8)
    assert (grown.pattern.shape, grown.pattern.dtype) == ((96, 128), np.float32)
    assert (grown.labels.shape, grown.labels.dtype) == ((96, 128), np.uint8)
    assert np.array_equal(grown.labels == 1, grown.pattern >= 0.5)
    assert np.array_equal(grown.layer_pattern(0), grown.pattern)
    assert grown.rgb.flags.owndata or grown.rgb.base is not None
    with pytest.raises(dapple.Error, match="allowed: 0 to 0"):
        grown.layer_pattern(1)


def test_the_bytes_are_those_of_the_command_line(tmp_path, grown):
    (tmp_path / "a.dapple").write_text(json.dumps(spots()))
    run = [PROGRAM, "grow", "a.dapple", "-o", "a.png", "--seed", "5", "-q"]
    subprocess.run(run, cwd=tmp_path, check=True)
    of_path = dapple.grow(tmp_path / "a.dapple", seed=5, threads=1)
    of_path.save(tmp_path / "b.png")
    assert (tmp_path / "b.png").read_bytes() == (tmp_path / "a.png").read_bytes()
    again = dapple.grow(tmp_path / "a.png")
    assert np.array_equal(again.rgb, of_path.rgb)
    assert not np.array_equal(again.rgb, grown.rgb)


def test_a_coat_with_a_finish_is_that_of_the_command_line(tmp_path):
    ground = {"noise": {"size": 60, "range": [0, 1]}}
    stops = [{"at": 0, "colour": "#c89048"}, {"at": 0.45, "colour": "#c89048"}, {"at": 0.55, "colour": "#281a12"}]
    colours = {"stops": stops, "ground": "#fff8e8", "halo": 0.2}
    marks = [dapple.ellipse([30 + 26 * k, 40 + 4 * k], [9, 6], angle=30) for k in range(3)]
    spotted = dapple.layer(marks, system=SPOTS, maps={"ground": ground}, colours=colours)
    finish = {"kind": "leather", "mottle": 0.05}
    coat = dapple.document([128, 96], layers=[spotted], warp={"size": 40, "by": 2}, finish=finish)
    (tmp_path / "a.dapple").write_text(json.dumps(coat))
    run = [PROGRAM, "grow", "a.dapple", "-o", "a.png", "--mask", "m.png", "--material", "maps", "-q"]
    subprocess.run(run, cwd=tmp_path, check=True)
    grown = dapple.grow(coat)
    grown.save(tmp_path / "b.png")
    assert (tmp_path / "b.png").read_bytes() == (tmp_path / "a.png").read_bytes()
    assert set(np.unique(grown.mask)) == {0, 1}
    grown.material(tmp_path / "own", name="a")
    for name in ("a_BaseColor.png", "a_Height.png", "a_Roughness.png"):
        assert (tmp_path / "own" / name).read_bytes() == (tmp_path / "maps" / name).read_bytes(), name
    fur = dapple.grow({**coat, "finish": {"kind": "fur"}})
    assert np.array_equal(fur.labels, grown.labels)
    assert not np.array_equal(fur.mask, grown.mask)
    fur.material(tmp_path / "fur", name="a")
    assert (tmp_path / "fur" / "a_Anisotropy.png").exists()


def test_the_report_says_what_was_asked_and_what_has_grown(grown):
    region = grown.report["layers"][0]["regions"][0]
    assert abs(region["got"]["area"] / region["asked"]["area"] - 1) < 0.05
    assert grown.document["layers"][0]["strokes"][0]["radii"] == [9, 6]
    measured = dapple.measure(grown.pattern)
    assert measured["kind"] == "spots"
    assert abs(measured["area"] / region["got"]["area"] - 1) < 0.1


def test_files_are_written(tmp_path, grown):
    grown.save(tmp_path / "large.png", scale=2)
    assert dapple.read(tmp_path / "large.png")["size"] == [128, 96]
    assert "<svg" in grown.outlines()
    grown.material(tmp_path / "material", name="spots", relief=4)
    names = sorted(path.name for path in (tmp_path / "material").iterdir())
    assert {"spots_BaseColor.png", "spots_Height.png", "spots.gltf"} <= set(names), names
    with pytest.raises(dapple.Error, match=r"\.jpg"):
        grown.save(tmp_path / "a.xyz")


@pytest.mark.parametrize(
    ("change", "place", "allowed"),
    [
        ({"edges": "round"}, "edges", "closed, wrap"),
        ({"dpi": 0}, "dpi", "a number from 1 to 100000 dots an inch"),
        ({"sizes": 3}, "the document", "format, version"),
    ],
)
def test_errors_name_the_place_and_the_remedy(change, place, allowed):
    with pytest.raises(dapple.Error) as caught:
        dapple.grow({**spots(), **change})
    assert caught.value.place == place
    assert allowed in caught.value.allowed
    assert str(caught.value).startswith(f"the document: {place}: found ")


def test_a_file_that_is_not_there_is_named():
    with pytest.raises(dapple.Error, match=r"nowhere\.dapple: cannot be read"):
        dapple.grow("nowhere.dapple")


def test_check_lists_notes_and_refuses_what_cannot_grow():
    assert len(dapple.check(spots())) == 1
    outside = dapple.document([64, 64], layers=[dapple.layer([dapple.ellipse([120, 32], [5, 5])])])
    with pytest.raises(dapple.Error) as caught:
        dapple.check(outside)
    assert caught.value.place == "layers[0].strokes[0]"


def test_progress_is_reported_and_its_exception_stops_the_growth():
    seen = []
    large = dapple.document([320, 320], layers=spots()["layers"])
    dapple.grow(large, progress=lambda stage, share: seen.append((stage, share)))
    assert seen
    assert all(stage in ("plan", "grow", "refine", "write") and 0 <= share <= 1 for stage, share in seen)

    def stop(stage, share):
        raise ValueError("enough")

    with pytest.raises(ValueError, match="enough"):
        dapple.grow(large, progress=stop)


def test_other_threads_run_while_a_texture_grows():
    counted, growing = [0], [True]

    def count():
        while growing[0]:
            counted[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    dapple.grow(dapple.document([400, 400], layers=spots()["layers"]), threads=1)
    growing[0] = False
    thread.join()
    assert counted[0] > 5, counted


# At the beginning, and while marks are placed: that step does not check for cancelling.
@pytest.mark.parametrize("share", ["0", "0.5"])
def test_ctrl_c_ends_a_growth(share):
    code = (
        "import dapple, signal, sys\n"
        # A process that is started in the background ignores Ctrl-C.
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
        "marks = [dapple.ellipse([30 + 8 * k, 40 + k], [2, 1.5], angle=30) for k in range(3)]\n"
        "large = dapple.document([2400, 2400], layers=[dapple.layer(marks)])\n"
        "try:\n    dapple.grow(large, progress=lambda *at: print(f'{at[0]} {at[1]:g}', flush=True))\n"
        "except KeyboardInterrupt:\n    print('stopped', flush=True); sys.exit(3)\n"
    )
    process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
    while process.stdout.readline() != f"plan {share}\n":
        assert process.poll() is None
    begun = time.monotonic()
    process.send_signal(signal.SIGINT)
    lines, _ = process.communicate(timeout=60)
    took = time.monotonic() - begun
    print(f"Ctrl-C took {took:.2f} s")
    assert lines.endswith("stopped\n")
    assert process.returncode == 3


SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n"


def test_a_model_has_what_the_command_line_grows_on_it(tmp_path):
    document = spots(model={"file": "square.obj", "px": 200})
    document["layers"][0]["system"] = SPOTS
    (tmp_path / "square.obj").write_text(SQUARE)
    (tmp_path / "a.dapple").write_text(json.dumps(document))
    run = [PROGRAM, "grow", "a.dapple", "-o", "a.glb", "--size", "128x128", "-q"]
    subprocess.run(run, cwd=tmp_path, check=True)
    grown = dapple.grow_on_model(tmp_path / "a.dapple")
    grown.save(tmp_path / "b.glb", size=[128, 128])
    assert (tmp_path / "b.glb").read_bytes() == (tmp_path / "a.glb").read_bytes()
    assert grown.unfit is None
    assert grown.report["layers"][0]["spots"] > 3
    again = dapple.grow_on_model(document, model=tmp_path / "square.obj")
    again.material(tmp_path / "maps", name="square", size=[64, 64])
    assert {"square_BaseColor.png", "square.gltf"} <= {path.name for path in (tmp_path / "maps").iterdir()}


def test_a_model_without_texture_coordinates_says_so_and_has_automatic_ones(tmp_path):
    document = spots(model={"file": "animal", "px": 300})
    document["layers"][0]["system"] = SPOTS
    grown = dapple.grow_on_model(document)
    assert "no texture coordinates" in grown.unfit
    grown.save(tmp_path / "animal.obj", size=[64, 64])
    assert "vt " in (tmp_path / "animal.obj").read_text()
    with pytest.raises(dapple.Error, match=r"\.glb, \.obj or \.ply"):
        grown.save(tmp_path / "animal.png")
    with pytest.raises(dapple.Error, match="grow_on_model"):
        dapple.grow(spots(model={"file": "animal"}))
    with pytest.raises(dapple.Error, match="found none") as caught:
        dapple.grow_on_model(spots())
    assert caught.value.place == "model"


def test_lookup_gives_parameters_in_cells():
    found = dapple.lookup("meinhardt-spots", angle=30, area=300, aspect=0.6, spacing=40)
    assert found["coverage"] in ("inside", "edge")
    assert found["parameters"]["cell"] > 0
    with pytest.raises(dapple.Error, match="meinhardt-lines"):
        dapple.lookup("spots", angle=0, width=3)
    with pytest.raises(dapple.Error, match="area and aspect of spots"):
        dapple.lookup("meinhardt-spots", angle=0)


def test_a_photograph_becomes_a_sketch(grown):
    wide = dapple.grow(spots(edges="wrap"), size=[256, 256])
    sketch = dapple.from_photo(wide.rgb)
    assert sketch["layers"][0]["strokes"]
    assert dapple.measure(wide.rgb)["kind"] == "spots"
    with pytest.raises(dapple.Error):
        dapple.measure(np.zeros((64, 64), np.float32))


def test_the_schema_allows_the_examples_and_refuses_what_the_reader_refuses():
    jsonschema = pytest.importorskip("jsonschema")
    schema = dapple.schema()
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    examples = sorted((ROOT / "examples").rglob("*.dapple"))
    assert len(examples) > 100
    for path in examples:
        validator.validate(json.loads(path.read_text()))
    for change in [{"edges": "round"}, {"size": [0, 5]}, {"layers": []}, {"sizes": 3}, {"dpi": "300"}]:
        assert not validator.is_valid({**spots(), **change})
        with pytest.raises(dapple.Error):
            dapple.grow({**spots(), **change})


def test_items_of_a_data_set_do_not_depend_on_their_order():
    first = [item for item, _ in zip(dapple.stream(3, size=80), range(7), strict=False)]
    assert [item.kind for item in first] == list(dapple.KINDS)
    later = next(dapple.stream(3, size=80, first=4))
    assert np.array_equal(later.rgb, first[4].rgb)
    assert np.array_equal(later.labels, first[4].labels)
    for item in first:
        assert (item.rgb.shape, item.labels.dtype) == ((80, 80, 3), np.uint16)
        assert item.size.shape == item.direction.shape == (80, 80)
        assert len(item.marks["label"]) == item.labels.max()
    again = dapple.grow(first[0].document)
    assert np.array_equal(again.rgb, first[0].rgb)
    with pytest.raises(dapple.Error, match="irregular-spots"):
        next(dapple.stream(1, kinds=["dots"]))


def test_items_are_those_of_the_command_line(tmp_path):
    run = [PROGRAM, "data-set", "-o", "set", "--count", "3", "--size", "80", "--seed", "3", "-q"]
    subprocess.run(run, cwd=tmp_path, check=True)
    item = next(dapple.stream(3, size=80, first=2))
    folder = tmp_path / "set/000000/000000002"
    again = dapple.grow(folder / "picture.png")
    assert np.array_equal(again.rgb, item.rgb)
    assert json.loads((folder / "item.json").read_text())["document"] == item.document
