#![no_main]

use libfuzzer_sys::fuzz_target;
use restitution_attack::parsers::Parser;

fuzz_target!(|bytes: &[u8]| if let Err(promise) = Parser::List.check(bytes) {
    panic!("{promise}");
});
