//! Languages, what drives a source, and the ways to build it. A driver reads bit patterns and prints those of the values.

/// A language and its tools.
#[derive(Debug)]
pub struct Language {
    /// As `--lang` takes it.
    pub name: &'static str,
    /// The file of the source.
    pub file: &'static str,
    /// The file of the driver.
    pub driver_file: &'static str,
    /// The driver.
    pub driver: &'static str,
    /// Ways to build, each in some steps.
    pub builds: &'static [&'static [&'static str]],
    /// What is run then.
    pub run: &'static str,
}

const C_DRIVER: &str = r#"
#include "restitution.h"
#include <stdio.h>
int main(void)
{
    unsigned long long bits;
    double u, epsilon, array;
    while (scanf("%llx", &bits) == 1) {
        memcpy(&u, &bits, sizeof u);
        epsilon = restitution_epsilon(u);
        restitution_epsilon_array(&u, &array, 1);
        if (memcmp(&epsilon, &array, sizeof array))
            return 3;
        memcpy(&bits, &epsilon, sizeof bits);
        printf("%016llx\n", bits);
    }
    return 0;
}
"#;

const FORTRAN_DRIVER: &str = "
program driver
    use, intrinsic :: iso_fortran_env, only: dp => real64, int64
    use restitution, only: restitution_epsilon
    implicit none
    integer(int64) :: bits
    integer :: status
    do
        read (*, '(z16)', iostat=status) bits
        if (status /= 0) exit
        print '(z16.16)', transfer(restitution_epsilon(transfer(bits, 0.0_dp)), bits)
    end do
end program
";

const RUST_DRIVER: &str = "
#[allow(dead_code)]
mod restitution;
fn main() {
    for line in std::io::stdin().lines() {
        let u = f64::from_bits(u64::from_str_radix(line.unwrap().trim(), 16).unwrap());
        println!(\"{:016x}\", restitution::restitution_epsilon(u).to_bits());
    }
}
";

const PYTHON_DRIVER: &str = "
import struct, sys
import numpy as np
from restitution import restitution_epsilon as epsilon
numbers = [struct.unpack('>d', bytes.fromhex(line))[0] for line in sys.stdin.read().split()]
several = epsilon(np.array(numbers))
for u, together in zip(numbers, several):
    alone = epsilon(u)
    assert alone == together or (alone != alone and together != together), (u, alone, together)
    print(struct.pack('>d', alone).hex())
";

/// The languages that are attacked, those with flags that change arithmetic first.
pub const LANGUAGES: [Language; 5] = [
    Language {
        name: "c",
        file: "restitution.h",
        driver_file: "driver.c",
        driver: C_DRIVER,
        builds: &[
            &["gcc -std=c99 -O0 -Wall -Wextra -Werror driver.c -o driver -lm"],
            &["gcc -O3 -march=native driver.c -o driver -lm"],
            &["gcc -O3 -ffast-math driver.c -o driver -lm"],
            &["gcc -g -O1 -fsanitize=address,undefined -fno-sanitize-recover=all driver.c -o driver -lm"],
            &[
                "gcc -O2 -ffast-math -fsanitize=address,undefined -fno-sanitize-recover=all driver.c -o driver -lm",
            ],
            &["clang -O3 -ffast-math driver.c -o driver -lm"],
        ],
        run: "./driver",
    },
    Language {
        name: "c",
        file: "restitution.h",
        driver_file: "driver.cpp",
        driver: C_DRIVER,
        builds: &[
            &["g++ -std=c++11 -O2 -Wall -Wextra -Werror driver.cpp -o driver"],
            &["g++ -Ofast driver.cpp -o driver"],
        ],
        run: "./driver",
    },
    Language {
        name: "fortran",
        file: "restitution.f90",
        driver_file: "driver.f90",
        driver: FORTRAN_DRIVER,
        builds: &[
            &["gfortran -std=f2008 -O0 -fcheck=all -Wall restitution.f90 driver.f90 -o driver"],
            &["gfortran -O3 -ffast-math restitution.f90 driver.f90 -o driver"],
            &[
                "gfortran -O1 -g -fcheck=all -fsanitize=address,undefined restitution.f90 driver.f90 -o driver",
            ],
        ],
        run: "./driver",
    },
    Language {
        name: "rust",
        file: "restitution.rs",
        driver_file: "driver.rs",
        driver: RUST_DRIVER,
        builds: &[
            &["rustc --edition=2021 -Dwarnings driver.rs -o driver"],
            &["rustc --edition=2021 -O -Ctarget-cpu=native driver.rs -o driver"],
        ],
        run: "./driver",
    },
    Language {
        name: "python",
        file: "restitution.py",
        driver_file: "driver.py",
        driver: PYTHON_DRIVER,
        builds: &[&["/usr/bin/python3 restitution.py"]],
        run: "/usr/bin/python3 driver.py",
    },
];
