//! What drives a source: reads arguments as 16 hexadecimal digits and prints `epsilon`, `1 - epsilon` and the slope so.

use super::tools::{command, compiled, python_with_numpy, run, rustc};
use std::path::Path;
use std::process::Command;

/// How a source of one language, written with the name `tried`, is checked and run.
pub struct Driver {
    /// The test that runs it.
    pub test: &'static str,
    pub language: &'static str,
    /// The file that the driver goes into.
    pub file: &'static str,
    pub source: &'static str,
    /// Flags that change no value.
    pub plain: &'static [&'static str],
    /// Lists of flags that people use.
    pub hostile: &'static [&'static [&'static str]],
    /// Runs the self-check and returns the command that runs the driver.
    pub build: fn(&Path, &[&str]) -> Option<Command>,
}

const C_FLAGS: &[&[&str]] = &[
    &["-O0"],
    &["-O3", "-ffast-math"],
    &["-Ofast", "-march=native", "-funsafe-math-optimizations", "-ffinite-math-only"],
    &["-O1", "-ffast-math", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"],
];
const CPP_FLAGS: &[&[&str]] = &[C_FLAGS[1], C_FLAGS[3]];
const FORTRAN_FLAGS: &[&[&str]] = &[
    &["-O0", "-fcheck=all"],
    &["-O3", "-ffast-math", "-fcheck=all"],
    &["-Ofast", "-march=native", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"],
];

pub static DRIVERS: &[Driver] = &[
    Driver {
        test: "rust",
        language: "rust",
        file: "driver.rs",
        source: r#"
mod tried;
fn main() {
    for line in std::io::stdin().lines() {
        let u = f64::from_bits(u64::from_str_radix(line.unwrap().trim(), 16).unwrap());
        let mut several = [0.0];
        tried::tried_epsilon_slice(&[u], &mut several);
        let (epsilon, loss, slope) = (tried::tried_epsilon(u), tried::tried_loss(u), tried::tried_slope(u));
        assert_eq!(epsilon.to_bits(), several[0].to_bits());
        println!("{:016x} {:016x} {:016x}", epsilon.to_bits(), loss.to_bits(), slope.to_bits());
    }
}
"#,
        plain: &["-O"],
        hostile: &[&["-Copt-level=0", "-Coverflow-checks=on"], &["-O", "-Ctarget-cpu=native"]],
        build: |folder, flags| {
            let flags = [&["--edition=2021", "-Dwarnings"], flags].concat();
            compiled(
                folder,
                &rustc(),
                &flags,
                &[(&["--test", "tried.rs"], "check"), (&["driver.rs"], "driver")],
            )
        },
    },
    Driver {
        test: "c",
        language: "c",
        file: "driver.c",
        source: C,
        plain: &["-O2"],
        hostile: C_FLAGS,
        build: |folder, flags| c_or_cpp(folder, "gcc", &["-std=c99", "-x", "c"], flags),
    },
    Driver {
        test: "cpp",
        language: "c",
        file: "driver.c",
        source: C,
        plain: &["-O2"],
        hostile: CPP_FLAGS,
        build: |folder, flags| c_or_cpp(folder, "g++", &["-std=c++11", "-x", "c++"], flags),
    },
    Driver {
        test: "fortran",
        language: "fortran",
        file: "driver.f90",
        source: r"
program driver
    use, intrinsic :: iso_fortran_env, only: dp => real64, int64
    use tried, only: tried_epsilon, tried_loss, tried_slope
    implicit none
    integer(int64) :: bits
    integer :: status
    real(dp) :: u
    do
        read (*, '(z16)', iostat=status) bits
        if (status /= 0) exit
        u = transfer(bits, u)
        print '(3(z16.16, 1x))', transfer([tried_epsilon(u), tried_loss(u), tried_slope(u)], [bits])
    end do
end program
",
        plain: &["-O2", "-Wall", "-Werror"],
        hostile: FORTRAN_FLAGS,
        build: |folder, flags| {
            std::fs::write(folder.join("check.f90"), "use tried; call tried_self_check(); end\n").unwrap();
            let flags = [&["-std=f2008"], flags].concat();
            let programs: &[(&[&str], &str)] =
                &[(&["tried.f90", "check.f90"], "check"), (&["tried.f90", "driver.f90"], "driver")];
            compiled(folder, "gfortran", &flags, programs)
        },
    },
    Driver {
        test: "python",
        language: "python",
        file: "driver.py",
        source: r#"
import struct, sys
from tried import tried_epsilon, tried_loss, tried_slope
for line in sys.stdin:
    (u,) = struct.unpack(">d", bytes.fromhex(line.strip()))
    values = tried_epsilon(u), tried_loss(u), tried_slope(u)
    print(*(struct.pack(">d", value).hex() for value in values))
"#,
        plain: &[],
        hostile: &[&["-X", "dev", "-W", "error"]],
        build: |folder, flags| python(folder, "python3", flags),
    },
    Driver {
        test: "numpy",
        language: "python",
        file: "driver.py",
        source: r#"
import struct, sys
import numpy as np
from tried import tried_epsilon, tried_loss, tried_slope
u = np.array([struct.unpack(">d", bytes.fromhex(line.strip()))[0] for line in sys.stdin])
u = np.append(u, u[:1]).reshape(-1, 1)
values = [tried_epsilon(u), tried_loss(u), tried_slope(u)]
assert all(several.shape == u.shape for several in values)
for row in np.hstack(values)[:-1]:
    print(*(struct.pack(">d", value).hex() for value in row))
"#,
        plain: &[],
        hostile: &[&["-W", "error"]],
        build: |folder, flags| python(folder, python_with_numpy()?, flags),
    },
    Driver {
        test: "javascript",
        language: "javascript",
        file: "driver.js",
        source: r#"
const tried = require("./tried.js");
const view = new DataView(new ArrayBuffer(8));
for (const line of require("fs").readFileSync(0, "latin1").trim().split("\n")) {
  view.setBigUint64(0, BigInt("0x" + line));
  const u = view.getFloat64(0);
  const values = [tried.epsilon(u), tried.loss(u), tried.slope(u)].map((value) => {
    view.setFloat64(0, value);
    return view.getBigUint64(0).toString(16).padStart(16, "0");
  });
  console.log(values.join(" "));
}
"#,
        plain: &[],
        hostile: &[&["--use-strict"]],
        build: |folder, flags| {
            run(&mut command("node", folder, &["tried.js"]), None)?;
            Some(command("node", folder, &[flags, &["driver.js"]].concat()))
        },
    },
    Driver {
        test: "matlab",
        language: "matlab",
        file: "driver.m",
        source: r"
lines = textscan(stdin, '%s'){1};
u = reshape(hex2num(lines), 1, []);
[epsilon, loss, slope] = tried_epsilon(u);
assert(isequal(size(epsilon), size(u)));
for i = 1:numel(u)
    printf('%s %s %s\n', num2hex(epsilon(i)), num2hex(loss(i)), num2hex(slope(i)));
end
",
        plain: &[],
        hostile: &[&[]],
        build: |folder, _| {
            let octave = ["--no-gui", "--quiet", "--no-init-file", "--no-history"];
            let check = [&octave[..], &["--eval", "tried_epsilon('check')"]].concat();
            run(&mut command("octave-cli", folder, &check), None)?;
            Some(command("octave-cli", folder, &[&octave[..], &["driver.m"]].concat()))
        },
    },
];

const C: &str = r#"
#include "tried.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
int main(void)
{
    unsigned long long bits;
    double u, several, values[3];
    uint64_t out[3];
    while (scanf("%llx", &bits) == 1) {
        out[0] = bits;
        memcpy(&u, out, sizeof u);
        tried_epsilon_array(&u, &several, 1);
        values[0] = tried_epsilon(u);
        values[1] = tried_loss(u);
        values[2] = tried_slope(u);
        if (memcmp(&values[0], &several, sizeof several))
            abort();
        memcpy(out, values, sizeof out);
        printf("%016" PRIx64 " %016" PRIx64 " %016" PRIx64 "\n", out[0], out[1], out[2]);
    }
    return 0;
}
"#;

fn c_or_cpp(folder: &Path, compiler: &str, language: &[&str], flags: &[&str]) -> Option<Command> {
    let flags = [language, &["-Wall", "-Wextra", "-pedantic", "-Werror"], flags].concat();
    let check = ["-DTRIED_SELF_CHECK", "tried.h", "-lm"];
    compiled(folder, compiler, &flags, &[(&check, "check"), (&["driver.c", "-lm"], "driver")])
}

fn python(folder: &Path, python: &str, flags: &[&str]) -> Option<Command> {
    run(&mut command(python, folder, &[flags, &["tried.py"]].concat()), None)?;
    Some(command(python, folder, &[flags, &["driver.py"]].concat()))
}
