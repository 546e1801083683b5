#!/bin/sh
# Makes the skeleton of a method: estimators/src/ID with both backends, and its two lines outside.
#
#   scripts/new-method.sh my_method
#
# The skeleton is a copy of constant_ambient, which works: change it step by step, and run
# `cargo run -- verify --estimator my_method` on the way. See CONTRIBUTING.md.
set -eu
cd "$(dirname "$0")/.."
usage() {
    echo "new-method: $1" >&2
    exit 2
}
[ $# -eq 1 ] || usage "give the method's id, such as: scripts/new-method.sh my_method"
id=$1
case $id in
    "" | [!a-z]* | *[!a-z0-9_]*) usage "'$id' is no id: lower-case letters, digits and underscores" ;;
esac
folder=estimators/src/$id
[ ! -e "$folder" ] || usage "$folder is there already: choose another id"
name=$(echo "$id" | awk -F_ '{ for (i = 1; i <= NF; i++) printf "%s%s", toupper(substr($i, 1, 1)), substr($i, 2) }')

cp -r estimators/src/constant_ambient "$folder"
rm -f "$folder/limits.png" "$folder/PAPER.md"
for file in "$folder"/*; do
    sed -i -e "s/constant_ambient/$id/g" -e "s/ConstantAmbient/$name/g" "$file"
done
# The picture belongs to the other method, and so does its caption.
sed -i -e '/limits\.png/,/^## /{/^## /!d}' "$folder/README.md"

# Two lines outside the folder: the module, in the order of the alphabet as rustfmt has it, and the entry.
awk -v line="pub mod $id;" '
    /^$/ { block++ }
    block == 2 && /^pub mod / && !done && $0 > line { print line; done = 1 }
    { print }
' estimators/src/lib.rs >estimators/src/lib.rs.new
mv estimators/src/lib.rs.new estimators/src/lib.rs
sed -i "s/^\( *\)\.with(Entry::cpu_only::<crate::path_reference::PathReference>())/\1.with(Entry::both::<crate::$id::$name>())\n&/" \
    estimators/src/registry.rs
echo "$folder: now edit math.rs and math.wgsl, cpu.rs and gpu.rs, params.rs, claims.rs and README.md"
