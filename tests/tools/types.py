"""Every struct, union and enum name of src/ is defined once: tools/house finds no other."""
import os
import subprocess
import sys

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
found = subprocess.run([os.path.join(TOP, "tools", "house"), "--list", "types"], capture_output=True, text=True, check=True)
print(found.stdout, end="")
sys.exit(1 if found.stdout.strip() else 0)
