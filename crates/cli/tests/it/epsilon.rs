//! `restitution epsilon`: digits, velocities, wrong input.

use crate::support::{fail, restitution, succeed};

#[test]
fn epsilon_prints_proved_digits() {
    let text = succeed("epsilon --u 0.1,1,8 --digits 30 --format csv");
    let expected = "u,epsilon\n0.1,0.892147587290229345269672993933\n1,0.331164810466640935279720797775\n\
        8,0.000157421316658559729504822417616\n";
    assert_eq!(text, expected);
}

#[test]
fn a_tiny_loss_keeps_its_digits() {
    // The limit of small u is -C_1 = 1.15344885809528879913... of reference.json.
    let text = succeed("epsilon --u 1e-30 --quantity loss --digits 20 --format csv");
    assert_eq!(text, "u,one_minus_epsilon\n1e-30,1.1534488580952887991e-30\n");
}

#[test]
fn saturation_prints_the_radius() {
    let text = succeed("epsilon --saturation --digits 27 --format csv");
    assert_eq!(text, "quantity,value\nR,1.38836192561582941006822465\nR^5,5.15838170426768521641430592\n");
}

#[test]
fn velocities_are_scaled_by_the_material() {
    // s = 1 means u = 1/|C_1|; two equal spheres with u^5 = 1, that is
    // A = (2/3) (2 pi^2)^(1/5) R/(Y/density)^(2/5) g^(-1/5) where 1 - nu^2 = 1.
    let at_g_star = succeed("epsilon --velocity 0.32cm/s --g-star 3.2mm/s --digits 12 --format csv");
    assert_eq!(at_g_star, "velocity,epsilon\n0.32cm/s,0.384109197923\n");
    let material = "--poisson 0 --density 1 --radius 1 --young 1 --dissipative-constant 1.2105275814933005";
    let text = succeed(&format!("epsilon --velocity 1 {material} --digits 6 --format csv"));
    assert_eq!(text, "velocity,epsilon\n1,0.331165\n");
    let still = succeed("epsilon --velocity 0 --g-star 1 --digits 5 --format csv");
    assert_eq!(still, "velocity,epsilon\n0,1.0000\n");
}

#[test]
fn wrong_requests_say_how_to_right_them() {
    for (line, remedy) in [
        ("epsilon", "--u <U>"),
        ("epsilon --u", "a value is required"),
        ("epsilon --u -1", "give a number of at least 0"),
        ("epsilon --u nan", "write it as 0.1, 1e-12 or 1/3"),
        ("epsilon --u 1 --digits 0", "give one from 1 to 10000"),
        ("epsilon --u 1 --velocity 1 --g-star 1", "cannot be used with"),
        ("epsilon --velocity 1", "--g-star"),
        ("epsilon --velocity 1 --g-star 0", "give --g-star with a positive value"),
        ("epsilon --velocity 1cm/s,1 --g-star 1", "give the unit with every value or with none"),
        ("epsilon --velocity 1s --g-star 1", "not a velocity"),
        ("epsilon --velocity -1 --g-star 1", "give its size"),
        ("epsilon --velocity 1 --dissipative-constant 1", "give --young"),
        ("epsilon --velocity 1 --dissipative-constant 1 --law 1,0", "give --g-star with another --law"),
        ("epsilon --u 1 --end zero-force --law 1,2", "needs A > GAMMA"),
        ("epsilon --saturation --law 1,0", "needs A > GAMMA and 2 GAMMA > A - 1"),
        ("epsilon --saturation --law 1.001,0.001", "larger than 1/2001"),
    ] {
        let (code, message) = fail(line);
        assert_eq!(code, 2, "{line}: {message}");
        assert!(message.contains(remedy), "{line}: {message}");
    }
    let (code, message) = fail("epsilon --u 2 --law 1,0");
    assert_eq!(code, 1);
    assert!(message.contains("never separate") && message.contains("give a smaller u"), "{message}");
}

#[test]
fn grids_and_units_are_read_like_lists() {
    let grid = succeed("epsilon --u 0.1:0.3:3 --digits 5 --format csv");
    assert_eq!(grid, succeed("epsilon --u 0.1,0.2,0.3 --digits 5 --format csv"));
    let grid = succeed("epsilon --velocity 1cm/s:1m/s:3log --g-star 1cm/s --digits 5 --format csv");
    let list = succeed("epsilon --velocity 1cm/s,10cm/s,1m/s --g-star 1cm/s --digits 5 --format csv");
    assert_eq!(grid, list);
    let (code, message) = fail("epsilon --u 0,5");
    assert!(code == 2 && message.contains("write 0.5"), "{message}");
}

#[test]
fn a_list_is_answered_where_it_can_be() {
    let out = restitution("epsilon --u 1,3,2 --law 1,0 --digits 10 --format csv").output().unwrap();
    assert_eq!(out.status.code(), Some(0));
    // exp(-pi/sqrt(3)) at zeta = 1/2; critical damping is u = 2.
    assert_eq!(String::from_utf8_lossy(&out.stdout), "u,epsilon\n1,0.1630335348\n3,\n2,\n");
    let message = String::from_utf8_lossy(&out.stderr).into_owned();
    assert!(message.contains("no value for u = 3, 2: ") && message.contains("never separate"), "{message}");
    assert_eq!(message.lines().count(), 1);

    let json = restitution("epsilon --u 1,2 --law 1,0 --digits 10 --format json").output().unwrap();
    assert!(String::from_utf8_lossy(&json.stdout).contains("null"));

    let (code, message) = fail("epsilon --u 2,3 --law 1,0");
    assert!(code == 1 && message.contains("no value for u = 2, 3: "), "{message}");
}

#[test]
fn overdamped_bodies_part_where_the_force_vanishes() {
    // exp(-(b/w) ln((b+w)/(b-w))), b = u/2, w = sqrt(b^2-1): w = 3/4 at u = 5/2; e^-2 at u = 2.
    let text = succeed("epsilon --u 2,2.5 --law 1,0 --end zero-force --digits 20 --format csv");
    assert_eq!(text, "u,epsilon\n2,0.13533528323661269189\n2.5,0.099212565748012467172\n");
}
