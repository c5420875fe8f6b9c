"""The golden ROS messages are what Python's yaml, with which ROS prints, makes of them."""

import sys

try:
    import yaml
except ImportError:
    sys.exit(77)

for path in sys.argv[1:]:
    with open(path, encoding="utf-8") as file:
        text = file.read()
    printed = yaml.dump(yaml.safe_load(text), sort_keys=False, default_flow_style=False)
    if printed != text:
        sys.exit(f"{path} is not what Python prints")
