#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes three.min.js, the part of three.js that the report page needs, and its LICENSE, from npm's packages. Needed only
# to move to another version: the repository carries both files.
set -euo pipefail
three=0.187.0 esbuild=0.28.2
here=$(dirname "$(readlink -f "$0")")
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
cd "$work"
npm install --silent --no-audit --no-fund "three@$three" "esbuild@$esbuild"

# The view has shaders of its own, so those of three.js are left empty: a third of the whole.
shaders=node_modules/three/src/renderers/shaders
for chunk in "$shaders"/ShaderChunk/*.glsl.js; do echo "export default '';" >"$chunk"; done
for shader in "$shaders"/ShaderLib/*.glsl.js; do echo "export const vertex = '', fragment = '';" >"$shader"; done
# The controls share the sources of the rest, from which the bundler takes only what is used.
sed -i "s|from 'three'|from 'three/src/Three.js'|" node_modules/three/examples/jsm/controls/OrbitControls.js

cp "$here/parts.js" .
cp node_modules/three/LICENSE "$here/LICENSE"
{
    echo "/* three.js $three, a part, made by make_bundle.sh."
    echo
    cat node_modules/three/LICENSE
    echo "*/"
    # ASCII, and nothing that could end a script element.
    npx esbuild parts.js --bundle --minify --format=iife --global-name=THREE --charset=ascii --line-limit=120
} | sed 's/©/(c)/' >"$here/three.min.js"
wc -c "$here/three.min.js"
