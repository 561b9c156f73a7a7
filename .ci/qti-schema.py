#!/usr/bin/env python3
"""Validate the items and the test of a QTI package: `.ci/qti-schema.py PACKAGE.zip SCHEMA.xsd`.

The schemas of the standard are not ours to hand out: they come with other QTI software. Files that a schema imports
are taken from the folder of schemas two levels above it, whatever address it gives. Needs `lxml`.
"""

import collections
import pathlib
import sys
import zipfile

from lxml import etree

package, schema = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
beside = {path.name: path for path in schema.parent.parent.rglob("*.xsd")}


class Beside(etree.Resolver):
    """Finds imported schemas by their names; nothing is fetched."""

    def resolve(self, url, public, context):
        if pathlib.Path(url).exists():
            return None
        path = beside.get(url.rsplit("/", 1)[-1])
        return self.resolve_filename(str(path), context) if path else None


parser = etree.XMLParser(no_network=True)
parser.resolvers.add(Beside())
rules = etree.XMLSchema(etree.parse(str(schema), parser))
count, faults = 0, collections.Counter()
with zipfile.ZipFile(package) as archive:
    for name in archive.namelist():
        if name.endswith(".xml") and name != "imsmanifest.xml":
            count += 1
            if not rules.validate(etree.fromstring(archive.read(name))):
                faults.update(f"{name}: {error.message}" for error in rules.error_log)
for fault, times in faults.most_common(20):
    print(f"{times} times {fault}", file=sys.stderr)
print(f"{count} files, {len(faults)} faults")
sys.exit(1 if faults or count == 0 else 0)
