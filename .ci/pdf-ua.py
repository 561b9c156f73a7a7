#!/usr/bin/env python3
"""Looks into PDF files for what PDF/UA-1 (ISO 14289-1) asks and a program can see: `.ci/pdf-ua.py FILE.pdf...`

Needs pikepdf (`pip install pikepdf`), which has nothing to do with the program that writes the files. Clauses are those of
the standard. What only people can judge, whether words fit what they stand for, is left to them.
"""

import re
import sys

import pikepdf

# Operators that leave ink, or place something that does.
INK = {"Tj", "TJ", "'", '"', "S", "s", "f", "F", "f*", "B", "B*", "b", "b*", "sh", "Do", "INLINE IMAGE"}


def faults(path):
    with pikepdf.open(path) as pdf:
        root = pdf.Root
        metadata = bytes(root.Metadata.read_bytes()).decode() if "/Metadata" in root else ""
        if not re.search(r"<pdfuaid:part>1</pdfuaid:part>|pdfuaid:part=\"1\"", metadata):
            yield "5: does not say that it is PDF/UA-1"
        if not re.search(r"<dc:title>.*?<rdf:li[^>]*>[^<]+<", metadata, re.S):
            yield "7.1: no title"
        if not bool(root.get("/ViewerPreferences", {}).get("/DisplayDocTitle", False)):
            yield "7.1: the title is not shown"
        if not bool(root.get("/MarkInfo", {}).get("/Marked", False)):
            yield "7.1: not marked as tagged"
        if bool(root.get("/MarkInfo", {}).get("/Suspects", False)):
            yield "7.1: tags are suspect"
        if not str(root.get("/Lang", "")):
            yield "7.2: no language"
        if "/StructTreeRoot" not in root:
            yield "7.1: no structure"
            return
        tagged, elements = structure(root.StructTreeRoot)
        roles = {str(own): str(usual) for own, usual in root.StructTreeRoot.get("/RoleMap", {}).items()}
        yield from of_elements(elements, roles)
        for number, page in enumerate(pdf.pages, 1):
            yield from of_page(page, number, tagged.get(page.objgen, set()))
        yield from fonts(pdf)


def structure(root):
    """The numbers of marked content by page, and the structure elements in reading order, each with its ancestors."""
    tagged, elements = {}, []

    def walk(node, page, above):
        if isinstance(node, pikepdf.Array):
            for kid in node:
                walk(kid, page, above)
        elif isinstance(node, int):
            tagged.setdefault(page.objgen, set()).add(int(node))
        elif isinstance(node, pikepdf.Dictionary):
            page = node.get("/Pg", page)
            kind = str(node.get("/Type", ""))
            if kind == "/MCR":
                tagged.setdefault(page.objgen, set()).add(int(node.MCID))
            elif kind != "/OBJR" and "/S" in node:
                elements.append((node, above))
                walk(node.get("/K", pikepdf.Array()), page, above + [str(node.S)])

    walk(root.get("/K", pikepdf.Array()), None, [])
    return tagged, elements


def of_elements(elements, roles):
    level = 0
    for node, above in elements:
        kind = roles.get(str(node.S), str(node.S))
        if kind in ("/Figure", "/Formula") and not (str(node.get("/Alt", "")) or str(node.get("/ActualText", ""))):
            yield f"7.3, 7.7: a {kind[1:]} without words"
        if heading := re.fullmatch(r"/H([1-6])", kind):
            if int(heading[1]) > level + 1:
                yield f"7.4: a heading of rank {heading[1]} after one of rank {level}"
            level = int(heading[1])
        if kind == "/TR" and not {"/Table", "/THead", "/TBody", "/TFoot"} & set(above[-1:]):
            yield "7.2: a row outside of a table"
        if kind in ("/TD", "/TH") and above[-1:] != ["/TR"]:
            yield "7.2: a cell outside of a row"
        if kind == "/LI" and above[-1:] != ["/L"]:
            yield "7.2: an entry outside of a list"
        if kind == "/TH" and not scope(node):
            yield "7.5: a heading of a table without the direction that it is for"


def scope(node):
    owned = node.get("/A", pikepdf.Array())
    for own in owned if isinstance(owned, pikepdf.Array) else [owned]:
        if isinstance(own, pikepdf.Dictionary) and "/Scope" in own:
            return True
    return False


def of_page(page, number, tagged):
    if "/Annots" in page and str(page.get("/Tabs", "")) != "/S":
        yield f"7.18.3: page {number}: tabs do not follow the structure"
    open_marks, seen = [], set()
    for operands, operator in pikepdf.parse_content_stream(page):
        name = str(operator)
        if name == "BDC":
            properties = operands[1]
            if isinstance(properties, pikepdf.Name):
                properties = page.Resources.Properties[properties]
            mark = properties.get("/MCID")
            open_marks.append("artifact" if str(operands[0]) == "/Artifact" else mark)
            if mark is not None:
                seen.add(int(mark))
        elif name == "BMC":
            open_marks.append("artifact" if str(operands[0]) == "/Artifact" else None)
        elif name == "EMC":
            open_marks.pop()
        elif name in INK and not any(mark is not None for mark in open_marks):
            yield f"7.1: page {number}: `{name}` is neither tagged nor decoration"
            return
    if missing := seen - tagged:
        yield f"7.1: page {number}: marked content that no structure has: {sorted(missing)[:5]}"
    if missing := tagged - seen:
        yield f"7.1: page {number}: structure without content: {sorted(missing)[:5]}"


def fonts(pdf):
    for object in pdf.objects:
        if not isinstance(object, pikepdf.Dictionary) or object.get("/Type") != pikepdf.Name.Font:
            continue
        name = str(object.get("/BaseFont", "a font"))
        if str(object.get("/Subtype")) == "/Type0" and "/ToUnicode" not in object:
            yield f"7.21.7: {name} does not say which letters it has"
        descriptor = object.get("/FontDescriptor")
        if descriptor is not None and not {"/FontFile", "/FontFile2", "/FontFile3"} & set(descriptor.keys()):
            yield f"7.21.4: {name} is not embedded"


def main(paths):
    if not paths:
        sys.exit(__doc__.split("\n")[0])
    broken = 0
    for path in paths:
        found = list(faults(path))
        broken += bool(found)
        for words in found:
            print(f"{path}: {words}")
    print(f"{len(paths) - broken} of {len(paths)} files have all that PDF/UA-1 asks and a program can see")
    sys.exit(1 if broken else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
