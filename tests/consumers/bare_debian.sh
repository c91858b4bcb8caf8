#!/usr/bin/env bash
# A check by hand: do the two commands of the README work on a Debian that has nothing but its base system?
#
#   tests/consumers/bare_debian.sh bookworm|trixie [FOLDER] [-- ARGUMENT of ./run ...]      as root; needs debootstrap
#
# Makes the base system of Debian 12 (bookworm) or 13 (trixie) in FOLDER (default build/bare-RELEASE) if it is not there,
# copies the files of this checkout that git does not ignore, runs the two commands (or ./run with what follows --) in it
# as root, and says of each how long it took and by how much the system grew. The packages come from $NACRE_DEBIAN_MIRROR,
# else from where this machine's apt has Debian from. FOLDER stays, for a second look; nothing stays mounted.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)
say() { printf 'bare_debian: %s\n' "$*" >&2; }

release=${1-}
[[ $release == bookworm || $release == trixie ]] || { say "which release? bookworm or trixie"; exit 2; }
shift
folder=$root/build/bare-$release
if (($#)) && [[ $1 != -- ]]; then folder=$(realpath -m -- "$1"); shift; fi
commands=("./run bake configs/scenes/morpho.toml -o out" "./run test")
if (($#)); then
    shift
    commands=("./run $*")
else
    for command in "${commands[@]}"; do
        grep -qF -- "$command" "$root/README.md" || { say "the README does not show '$command'"; exit 1; }
    done
fi
mirror=${NACRE_DEBIAN_MIRROR-}
if [[ -z $mirror ]] && command -v apt-get > /dev/null; then
    # shellcheck disable=SC2016  # apt's own placeholder
    mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Origin: Debian' 'Label: Debian' | head -n 1)
fi

if [[ ! -e $folder/etc/debian_version ]]; then
    mkdir -p -- "$folder"
    debootstrap --variant=minbase "$release" "$folder" ${mirror:+"$mirror"}
fi
cp /etc/resolv.conf "$folder/etc/"
mkdir -p "$folder/nacre"
find "$folder/nacre" -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf -- {} +  # what an earlier run left
git -C "$root" ls-files -z --cached --others --exclude-standard |
    tar -C "$root" --null --files-from - --create | tar -C "$folder/nacre" --extract

megabytes() { du -smx --exclude=./nacre --exclude=./var/cache/apt "$folder" | cut -f1; }
trap 'umount "$folder/proc" "$folder/dev"' EXIT
mount --bind /proc "$folder/proc"
mount --bind /dev "$folder/dev"
for command in "${commands[@]}"; do
    before=$(megabytes)
    SECONDS=0
    status=0
    chroot "$folder" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root CI=true ${http_proxy:+"http_proxy=$http_proxy"} \
        sh -c "cd /nacre && $command" || status=$?
    say "$release: '$command': exit code $status, $SECONDS s, $(($(megabytes) - before)) MB more"
    ((status == 0)) || exit "$status"
done
