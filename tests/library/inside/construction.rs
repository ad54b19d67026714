//! Names of images and normals as they stand on the blackboard.

use kinegon::construction::{display, image_name, normal_name};

#[test]
fn names_as_on_the_blackboard() {
    assert_eq!(image_name("S3"), "s3");
    assert_eq!(image_name("P"), "p'");
    assert_eq!(image_name("P'"), "p''");
    assert_eq!(image_name("P_3"), "p_3");
    assert_eq!(normal_name("B", "S3"), "n_b3");
    assert_eq!(display("n_b3"), "n_{b3}");
    assert_eq!(display("S3"), "S_{3}");
    assert_eq!(display("B"), "B");
    assert_eq!(display("12"), "12");
    assert_eq!(display("2/1"), "2/1");
}
