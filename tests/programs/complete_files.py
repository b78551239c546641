# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether files are complete that an interrupted or failed run has left."""
import csv
import json
import xml.etree.ElementTree

import h5py


def check_complete(path):
    """Fails unless a file can be read to its end. Kept files have a checksum, which --resume looks at."""
    if path.suffix == ".json":
        json.loads(path.read_text())
    elif path.suffix == ".h5":
        with h5py.File(path) as file:
            file.visititems(lambda _, item: item[()] if isinstance(item, h5py.Dataset) else None)
    elif path.suffix in (".vtu", ".pvd"):
        xml.etree.ElementTree.parse(path)
    elif path.suffix == ".csv":
        with open(path, newline="") as file:
            assert len({len(row) for row in csv.reader(file)}) == 1, path
    elif path.suffix == ".prm":
        assert path.read_text().rstrip().endswith("end"), path
    elif path.name.endswith("_failed.txt"):
        assert path.read_text().strip(), path
    else:
        # What was being written has the ending that says so.
        assert path.suffix == ".part" or "kept" in path.parts, path
