"""Reads files for learning management systems back, by the rules of those who import them, and prints what they would have as JSON.

    python3 read.py moodle quiz.xml
    python3 read.py canvas quizzes.zip
    python3 read.py scorm page.zip

The regular expressions for Moodle are facts of its importer (question/type/multianswer/questiontype.php), those for numbers in Canvas of
its own (numeric questions of gems/plugins/qti_exporter): a number with its margin, or with both ends.
"""

import base64
import html
import json
import re
import sys
import xml.etree.ElementTree as ET
import zipfile
import zlib

# A field of a cloze question: {weight:TYPE:alternative~alternative …}, an alternative as =value#feedback or %50%value#feedback.
FRACTION = r"=|%(-?[0-9]+(?:[.,][0-9]*)?)%"
ANSWER = r".+?(?<!\\|&)(?<!&amp;)(?=[~#}]|$)"
FEEDBACK = r".*?(?<!\\)(?=[~}]|$)"
ALTERNATIVE = rf"((?:{FRACTION}))?({ANSWER})(#({FEEDBACK}))?"
START = r"\{\s*([0-9]*)\s*:\s*(NUMERICAL|NM)\s*:\s*"
FIELD = rf"{START}({ALTERNATIVE}(~{ALTERNATIVE})*)\}}"
NUMBER = r"-?(?:(?:[0-9]+[.,]?[0-9]*|[.,][0-9]+)(?:[eE][-+]?[0-9]+)?)"
NUMERICAL = rf"^({NUMBER})(?::({NUMBER}))?$"


def alternatives(field):
    """What a field's alternatives are, as the importer takes them off one by one."""
    found = []
    while match := re.match(rf"~?{ALTERNATIVE}", field, re.S):
        mark, percent, answer, _, said = match.groups()
        number = re.match(NUMERICAL, answer, re.S)
        if number is None:
            raise SystemExit(f"no number: {answer!r}")
        fraction = 100.0 if mark == "=" else float(percent or 0)
        value, tolerance = (float(part.replace(",", ".")) for part in number.groups("0"))
        if said is not None:
            said = html.unescape(said).replace(r"\}", "}").replace(r"\#", "#")
        found.append({"percent": fraction, "value": value, "tolerance": tolerance, "said": said})
        field = field[match.end():]
    if field:
        raise SystemExit(f"left over: {field!r}")
    return found


def moodle(path):
    root = ET.parse(path).getroot()
    assert root.tag == "quiz", root.tag
    read = {"category": root.findtext("question[@type='category']/category/text"), "questions": []}
    for question in root.findall("question[@type='cloze']"):
        text = question.findtext("questiontext/text")
        fields = []
        while match := re.search(FIELD, text, re.S):
            fields.append({"weight": int(match[1]), "answers": alternatives(match[3])})
            text = text[:match.start()] + "\x00" + text[match.end():]
        files = {}
        for file in question.iter("file"):
            assert file.get("encoding") == "base64" and file.get("path") == "/", file.attrib
            files[file.get("name")] = base64.b64decode(file.text, validate=True).hex()
        feedback = question.findtext("generalfeedback/text")
        used = re.findall(r"@@PLUGINFILE@@/([^\"]+)", text + feedback)
        name = question.findtext("name/text")
        about = {"idnumber": question.findtext("idnumber"), "tags": [tag.findtext("text") for tag in question.iterfind("tags/tag")]}
        read["questions"].append({"name": name, **about, "text": text, "fields": fields, "files": files, "used": used})
    return read


def canvas(path):
    package = zipfile.ZipFile(path)
    names = package.namelist()
    manifest = ET.fromstring(package.read("imsmanifest.xml"))
    listed = {e.get("href"): e.get("type") for e in manifest.iter() if e.tag.endswith("}resource")}
    quizzes = []
    for path in (path for path, kind in listed.items() if kind == "imsqti_xmlv1p2"):
        root = ET.fromstring(package.read(path))
        space = {"q": "http://www.imsglobal.org/xsd/ims_qtiasiv1p2"}
        quiz = root.find("q:assessment", space)
        items = []
        for item in quiz.iterfind("q:section/q:item", space):
            entries = [(f.findtext("q:fieldlabel", None, space), f.findtext("q:fieldentry", None, space)) for f in item.iter(f"{{{space['q']}}}qtimetadatafield")]
            answers = []
            for condition in item.iterfind("q:resprocessing/q:respcondition", space):
                score = condition.find("q:setvar", space)
                if score is None:
                    continue
                equal = condition.find(".//q:varequal", space)
                ends = [float(condition.findtext(f".//q:{end}", None, space)) for end in ("vargte", "varlte")]
                assert equal.get("margintype") == "absolute" and (score.get("varname"), score.get("action")) == ("SCORE", "Set")
                answers.append({"percent": float(score.text), "value": float(equal.text), "tolerance": float(equal.get("margin")), "ends": ends})
            text = item.findtext("q:presentation/q:material/q:mattext", None, space)
            said = item.findtext("q:itemfeedback/q:flow_mat/q:material/q:mattext", None, space)
            used = re.findall(r"%24IMS-CC-FILEBASE%24/([^\"]+)", text)
            items.append({"title": item.get("title"), "metadata": dict(entries), "answers": answers, "text": text, "said": said, "used": used})
        quizzes.append({"ident": quiz.get("ident"), "title": quiz.get("title"), "items": items})
    return {"names": names, "listed": listed, "quizzes": quizzes}


def scorm(path):
    package = zipfile.ZipFile(path)
    manifest = ET.fromstring(package.read("imsmanifest.xml"))
    space = {"m": "http://www.imsproject.org/xsd/imscp_rootv1p1p2"}
    resource = manifest.find("m:resources/m:resource", space)
    organization = manifest.find("m:organizations/m:organization", space)
    page = package.read(resource.get("href")).decode()
    links = re.findall(r'"1=([A-Za-z0-9_-]+)"', page)
    opened = [json.loads(zlib.decompress(base64.urlsafe_b64decode(link + "=" * (-len(link) % 4)), -15)) for link in links]
    return {
        "names": package.namelist(),
        "version": manifest.findtext("m:metadata/m:schemaversion", None, space),
        "default": manifest.find("m:organizations", space).get("default") == organization.get("identifier"),
        "title": organization.findtext("m:title", None, space),
        "pass": organization.findtext("m:item/{http://www.adlnet.org/xsd/adlcp_rootv1p2}masteryscore", None, space),
        "starts": organization.find("m:item", space).get("identifierref") == resource.get("identifier"),
        "kind": resource.get("{http://www.adlnet.org/xsd/adlcp_rootv1p2}scormtype"),
        "files": [file.get("href") for file in resource.iterfind("m:file", space)],
        "opened": opened,
        "page": page,
    }


if __name__ == "__main__":
    print(json.dumps({"moodle": moodle, "canvas": canvas, "scorm": scorm}[sys.argv[1]](sys.argv[2])))
