"""Validates problem files against a JSON schema: problem_schema.py SCHEMA PROBLEM...

Each file is also tried with an unknown key planted into each of its sections, which must be found.
Exit code 77 (skipped) without the packages jsonschema and yaml."""

import copy
import json
import pathlib
import sys

try:
    import jsonschema
    import yaml
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)


class Loader(yaml.SafeLoader):
    """`off` is a word, as in YAML 1.2, and 1e-5 a number."""


Loader.yaml_implicit_resolvers = {
    first: [(tag, pattern) for tag, pattern in resolvers if not tag.endswith((":bool", ":float"))]
    for first, resolvers in yaml.SafeLoader.yaml_implicit_resolvers.items()
}
Loader.add_implicit_resolver(
    "tag:yaml.org,2002:bool", yaml.resolver.re.compile("^(true|false)$"), list("tf"))
Loader.add_implicit_resolver(
    "tag:yaml.org,2002:float",
    yaml.resolver.re.compile(r"^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$"), list("-+.0123456789"))

validator = jsonschema.Draft202012Validator(json.loads(pathlib.Path(sys.argv[1]).read_text()))
validator.check_schema(validator.schema)
faults = 0
for file in sys.argv[2:]:
    problem = yaml.load(pathlib.Path(file).read_text(), Loader)
    for error in validator.iter_errors(problem):
        print(f"{file}: {error.json_path}: {error.message}")
        faults += 1
    for section, value in problem.items():
        planted = copy.deepcopy(problem)
        planted[section]["no_such_key"] = 1
        if validator.is_valid(planted):
            print(f"{file}: an unknown key in {section} is not found")
            faults += 1
sys.exit(faults != 0 or len(sys.argv) < 3)
