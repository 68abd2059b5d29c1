#![no_main]

use libfuzzer_sys::fuzz_target;
use restitution_attack::parsers::Parser;

fuzz_target!(|bytes: &[u8]| if let Err(promise) = Parser::Number.check(bytes) {
    panic!("{promise}");
});
