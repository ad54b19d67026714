use super::{BodyId, Mechanism};
use crate::scene::{Scene, SceneError};

/// Why a scene is no mechanism that can be solved.
#[derive(Debug, thiserror::Error)]
pub enum StructureError {
    /// Something in the scene does not fit together.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The group has prismatic joints in places where it never has a definite motion.
    #[error(
        "links {links} have no definite motion in any position: a fourth-class group with its prismatic joints as in {pattern} \
         (joints B C D E F G) is singular by its structure\n  try: make one of the prismatic joints revolute"
    )]
    Singular {
        /// The group's links.
        links: String,
        /// R or P for the joints B C D E F G.
        pattern: String,
    },
}

impl StructureError {
    /// The links that are to be solved form no fourth-class group; says what they have instead.
    pub(super) fn not_fourth_class(
        scene: &Scene,
        mechanism: &Mechanism,
        members: &[BodyId],
        joints: usize,
    ) -> Self {
        if members.is_empty() {
            return scene
                .error_at(
                    &["links"],
                    "nothing to solve: every link's motion is given",
                    Some("add the links of a fourth-class group between the known points".into()),
                )
                .into();
        }
        let names: Vec<&str> = members
            .iter()
            .map(|&b| mechanism.body(b).name.as_str())
            .collect();
        let freedoms = 3 * members.len() as i64 - 2 * joints as i64;
        let count = match freedoms {
            0 => "no free motion left, but another shape".to_owned(),
            n if n > 0 => {
                format!("{n} degree(s) of freedom too many: a joint or a drive is missing")
            }
            n => format!("{} constraint(s) too many", -n),
        };
        let message = format!(
            "links {} with {joints} joints form no fourth-class group ({count})",
            names.join(", ")
        );
        let hint = "this version solves one fourth-class group per scene: two links that hang on known points or driven links, \
                    and two closure links that each join both of them (4 links, 6 joints)";
        scene
            .error_at(&["links"], message, Some(hint.into()))
            .into()
    }
}
