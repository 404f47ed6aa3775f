#!/bin/sh
# Run a core part of the tests on AArch64 under emulation: tools/arm64.sh [pytest's arguments]
#
# First the bits of right-hand sides and trajectories are compared with this processor's, then tests
# run, by default those of sine and cosine and of the solvers' orders.
#
# Everything is put into build/arm64; nothing is installed on the system. It takes qemu-user and an
# arm64 Python from Debian's packages, unpacked, and wheels of that platform from pip's index. It
# needs apt-get and dpkg-deb (Debian or a descendant) and the environment of `make test`.
set -eu
cd "$(dirname "$0")/.."
tree=$PWD
here=$tree/build/arm64
root=$here/root
site=$here/site
python=$here/python

# Package lists of our own, so that the system's stay as they are: unpack ARCHITECTURE FOLDER HOW PACKAGES
unpack() {
    architecture=$1
    folder=$2
    command=$3
    shift 3
    state=$here/apt-$architecture
    mkdir -p "$state/lists/partial" "$state/archives/partial" "$folder"
    : >>"$state/status"
    apt() {
        apt-get -qq -y -o APT::Architecture="$architecture" -o APT::Architectures="$architecture" \
            -o Dir::State="$state" -o Dir::State::status="$state/status" -o Dir::Cache="$state" \
            -o Debug::NoLocking=true -o APT::Sandbox::User=root "$@"
    }
    apt update
    (cd "$state/archives" && apt $command "$@")
    for package in "$state"/archives/*.deb; do
        dpkg-deb --extract "$package" "$folder"
    done
}

if ! [ -x "$python" ]; then
    rm -rf "$here"
    # Static, so that it needs none of the system's libraries.
    unpack "$(dpkg --print-architecture)" "$here/host" download qemu-user-static
    unpack arm64 "$root" "--no-install-recommends --download-only install" python3 libstdc++6
    version=$(basename "$(ls "$root"/usr/bin/python3.[0-9]*)")
    .venv/bin/python -m pip install --quiet --disable-pip-version-check --target "$site" \
        --only-binary=:all: --implementation cp --python-version "${version#python}" \
        --platform manylinux_2_28_aarch64 --platform manylinux_2_27_aarch64 \
        --platform manylinux_2_17_aarch64 --platform manylinux2014_aarch64 \
        lazy_loader llvmlite numpy scipy sympy mpmath platformdirs pytest hypothesis
    # A child process of the emulated Python finds its way through this file again.
    cat >"$python" <<END
#!/bin/sh
PYTHONHOME='$root/usr' exec '$here/host/usr/bin/qemu-aarch64-static' -L '$root' -0 "\$0" \\
    '$root/usr/bin/$version' "\$@"
END
    chmod +x "$python"
fi

PYTHONPATH=$tree/src .venv/bin/python tools/bits.py >"$here/bits-here.txt"
export PYTHONPATH="$site:$tree/src" PYDY_CACHE_DIR="$here/cache" PYTHONDONTWRITEBYTECODE=1
"$python" tools/bits.py >"$here/bits-arm64.txt"
diff "$here/bits-here.txt" "$here/bits-arm64.txt"
echo "$(wc -l <"$here/bits-here.txt") results of $(uname -m) and AArch64 agree to the last bit"

[ $# -gt 0 ] || set -- tests/_backends/llvm/test_backend.py tests/solvers/test_order.py -k "sin or cos or order"
exec "$python" -m pytest -q -p no:cacheprovider "$@"
