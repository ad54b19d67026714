/// The catalogue, a row for each mistake: what it is; its name in results; its approximate share of the drawings with a
/// mistake, in per cent, which decides only where the values alone do not; the function that lists it wherever it could be
/// made; the keys of its pairs of sentences in the languages' files, with their blanks.
macro_rules! catalogue {
    ($declare:ident) => {
        $declare! {
            /// A ray drawn parallel in place of perpendicular, or the other way round.
            TurnedRay "turned-ray" 6.0 rays::turned {
                turned_ray(from, to)
                /// Both rays to an image.
                turned_rays(from, to, other)
            }
            /// A cut line drawn along the guide in place of normal to it.
            TurnedCutLine "turned-cut-line" 4.0 rays::turned_cut_line { turned_cut_line(joint, point) }
            /// A ray drawn from the wrong plan point.
            RayFromWrongPoint "ray-from-wrong-point" 5.0 rays::from_wrong_point {
                ray_from_wrong_point(image, wrong, right)
            }
            /// A special point taken from the wrong pair of lines.
            WrongLines "wrong-lines" 4.0 rays::wrong_lines { wrong_lines(point, wrong, right) }
            /// A vector laid off reversed.
            ReversedVector "reversed-vector" 4.0 vectors::reversed { reversed_vector(from, to) }
            /// A vector laid off in another direction: across, or off by an angle as from a misread protractor.
            TurnedVector "turned-vector" 3.0 vectors::turned {
                turned_vector(from, to)
                /// A crank's vectors in both plans, turned by an angle.
                turned_vectors(from, to, degrees)
            }
            /// A normal part or a Coriolis acceleration laid off from the wrong point.
            VectorFromWrongPoint "vector-from-wrong-point" 3.0 vectors::from_wrong_point {
                vector_from_wrong_point(end, wrong, right)
            }
            /// A normal acceleration that points outward.
            NormalOutward "normal-outward" 6.0 vectors::outward {
                normal_outward(from, to, rate, length)
                normals_outward(vectors)
            }
            /// A normal part with ω in place of ω².
            OmegaNotSquared "omega-not-squared" 5.0 vectors::not_squared {
                omega_not_squared(from, to, rate, length)
                omegas_not_squared(vectors)
            }
            /// The ω of another link in a normal part or a Coriolis acceleration.
            OmegaOfAnotherLink "omega-of-another-link" 3.0 vectors::omega_of_another {
                /// `factor` is a length or a velocity.
                omega_of_another_link(from, to, rate, factor, wrong)
                /// Those of two links in place of each other.
                omegas_interchanged(from, to, rate, wrong)
            }
            /// A normal part, or all products of a crank, with the diameter in place of the radius.
            Diameter "diameter" 3.0 vectors::diameter {
                diameter(from, to, rate, length)
                diameter_throughout(length)
            }
            /// All products of a crank with half its radius.
            HalfTheRadius "half-the-radius" 2.0 lengths::half_the_radius { half_the_radius(length) }
            /// A normal part from an absolute velocity, or from that of another link.
            NormalFromAbsolute "normal-from-absolute" 3.0 vectors::from_absolute {
                normal_from_absolute(from, to, rate, length, velocity)
            }
            /// A normal part forgotten.
            NormalForgotten "normal-forgotten" 6.0 vectors::normal_forgotten {
                normal_forgotten(from, to, rate, length)
                normals_forgotten(vectors)
            }
            /// A tangential part of a crank that turns evenly.
            TangentialWhereNone "tangential-where-none" 2.0 vectors::tangential_where_none {
                tangential_where_none(from, to, rate, length)
            }
            /// The Coriolis part forgotten.
            CoriolisForgotten "coriolis-forgotten" 6.0 vectors::coriolis_forgotten {
                coriolis_forgotten(from, to, rate, velocity)
            }
            /// The Coriolis part without its 2.
            CoriolisWithoutTwo "coriolis-without-2" 4.0 vectors::coriolis_without_two {
                coriolis_without_two(from, to, rate, velocity)
            }
            /// The Coriolis part turned the wrong way.
            CoriolisTurned "coriolis-turned" 5.0 vectors::coriolis_turned { coriolis_turned(from, to, rate, velocity) }
            /// The Coriolis part laid off along the guide.
            CoriolisAlong "coriolis-along-guide" 2.0 vectors::coriolis_along { coriolis_along(from, to, rate, velocity) }
            /// The Coriolis part with another velocity than the sliding one.
            CoriolisVelocity "coriolis-wrong-velocity" 3.0 vectors::coriolis_of_wrong_velocity {
                coriolis_velocity(from, to, rate, velocity, wrong)
                coriolis_velocity_and_omega(from, to, rate, velocity, wrong, omega)
            }
            /// A Coriolis part where nothing slides.
            CoriolisWhereNone "coriolis-where-none" 2.0 vectors::coriolis_where_none {
                coriolis_where_none(from, to, rate, length)
            }
            /// A Coriolis part at a guide that is at rest.
            CoriolisAtRest "coriolis-at-rest" 2.0 vectors::coriolis_at_rest { coriolis_at_rest(from, to, rate, velocity) }
            /// The image of a link mirrored.
            MirroredImage "mirrored-image" 3.0 images::mirrored {
                /// `other` is the image that fixes the side.
                mirrored_image(start, point, other)
                /// A point on a line of its link, on the wrong side of an end.
                beyond_end(start, point, other)
            }
            /// The image of a point in the wrong ratio to two others.
            WrongRatio "wrong-ratio" 3.0 images::wrong_ratio {
                /// The line between two images, divided from its wrong end.
                wrong_ratio(from, to, point)
                inverse_ratio(from, to, point)
                /// The triangle on two images with its distances from both exchanged.
                distances_exchanged(from, to, point)
                distances_exchanged_and_mirrored(from, to, point)
            }
            /// A segment measured from the wrong point.
            WrongSegment "wrong-segment" 8.0 lengths::wrong_segment { wrong_segment(segment, from, to) }
            /// A component taken for a length.
            Component "component" 4.0 lengths::component { component(segment, axis, from, to) }
            /// A wrong length, once or throughout.
            WrongLength "wrong-length" 4.0 lengths::wrong_length {
                wrong_length(length, from, to)
                wrong_length_throughout(length, from, to)
            }
            /// An angular velocity found with another link's length.
            OmegaFromWrongLength "omega-from-wrong-length" 4.0 rates::omega_from_wrong_length {
                omega_from_wrong_length(rate, from, to, length)
                /// The normal part is found with that length, too.
                omega_and_normal_from_wrong_length(rate, from, to, length, normal)
            }
            /// An angular acceleration found with another link's length.
            AlphaFromWrongLength "alpha-from-wrong-length" 3.0 rates::alpha_from_wrong_length {
                alpha_from_wrong_length(rate, from, to, length)
            }
            /// A rate of rotation without division by the length.
            NotDividedByLength "not-divided-by-length" 2.0 rates::not_divided { not_divided_by_length(rate, length) }
            /// A rate taken with the wrong sense.
            WrongSense "wrong-sense" 6.0 rates::wrong_sense {
                wrong_sense(rate)
                /// A given rate, of which the first vector shows it.
                wrong_sense_given(rate, from, to)
            }
            /// All rates of rotation written with the wrong sense.
            SensesReversed "senses-reversed" 3.0 rates::senses_reversed { senses_reversed() }
            /// Revolutions per minute taken for radians per second, or the other way round.
            RevolutionsForRadians "revolutions-for-radians" 5.0 rates::revolutions {
                revolutions_for_radians(rate)
                /// A given rate; of the next two mistakes, too.
                rate_in_other_unit(rate, number, given, taken)
            }
            /// Revolutions per second taken for radians per second, or the other way round.
            RevolutionsPerSecond "revolutions-per-second" 2.0 rates::revolutions_per_second {
                revolutions_per_second(rate)
            }
            /// Degrees taken for radians, or the other way round.
            DegreesForRadians "degrees-for-radians" 3.0 rates::degrees { degrees_for_radians(rate) }
            /// A segment taken with the wrong scale.
            WrongScale "wrong-scale" 4.0 rates::wrong_scale {
                wrong_scale(segment, wrong, scale)
                scale_forgotten(segment, scale)
            }
            /// The centre of a guide sought along it, not normal to it.
            CenterAlongGuide "centre-along-guide" 6.0 centers::along_guide { center_along_guide(center, guide) }
            /// The centre of a guide taken in the pin of its block.
            CenterAtSlider "centre-at-slider" 3.0 centers::at_slider { center_at_slider(center, pin, guide) }
            /// An instant centre marked where lines cross that do not both lead to it.
            LinesWithoutCommonLink "lines-without-common-link" 5.0 centers::other_lines {
                line_without_common_link(center, wrong, right)
                /// Where the lines of another centre cross.
                center_of_other_lines(center, other)
                centers_swapped(first, second)
            }
            /// A ratio of distances of centres, or of numbers of teeth, upside down.
            RatioInverted "ratio-inverted" 5.0 teeth::inverted {
                ratio_inverted(rate, over, under)
                /// Of the teeth of two wheels.
                teeth_inverted(first, second)
            }
            /// The sense of a rate or a velocity by centres reversed.
            SenseByCenter "sense-by-centre" 6.0 by_centers::sense_by_center {
                sense_by_center(rate)
                velocity_reversed(velocity)
            }
            /// A distance from another place than the centre that is meant.
            DistanceFromWrongCenter "distance-from-wrong-centre" 5.0 by_centers::from_wrong_center {
                distance_from_wrong_center(length, from, to)
            }
            /// The lines of a centre not drawn far enough, other ones crossed.
            NotExtended "not-extended" 5.0 routes::not_extended { not_extended(center, first, second) }
            /// A velocity laid off along its ray.
            VelocityAlongRay "velocity-along-ray" 3.0 by_centers::velocity_along_ray { velocity_along_ray(velocity) }
            /// A centre in a pin of three links missed.
            PinOfThree "pin-of-three" 4.0 centers::pin_of_three { pin_of_three(center, pin) }
            /// Millimetres of paper of the figure of centres taken for lengths.
            LengthsWithoutScale "lengths-without-scale" 4.0 rates::without_scale { lengths_without_scale(lengths, scale) }
            /// The force of inertia along the acceleration, not against it.
            InertiaAlongA "inertia-along-a" 5.0 forces::inertia_along { inertia_along_a(load) }
            /// The couple of inertia in the sense of the angular acceleration.
            InertiaCoupleAlongAlpha "inertia-couple-along-alpha" 5.0 forces::couple_along {
                inertia_couple_along_alpha(load)
            }
            /// A couple left out of the moments.
            CoupleForgotten "couple-forgotten" 5.0 forces::couple_forgotten { couple_forgotten(load) }
            /// Force and couple of inertia as one force on the wrong side of the centre.
            PercussionOnWrongSide "percussion-on-wrong-side" 1.0 forces::percussion { percussion_on_wrong_side(load) }
            /// The acceleration of a joint in place of that of the centre of mass.
            AOfJointForCentre "a-of-joint-for-centre" 3.0 forces::joint_for_center { a_of_joint_for_centre(load, point) }
            /// The centripetal part left out of the acceleration of the centre of mass.
            CentripetalPartLeftOut "centripetal-part-left-out" 3.0 forces::centripetal_left_out {
                centripetal_part_left_out(load, point)
            }
            /// An arm measured to the point where a force acts, not to its line.
            ArmToPoint "arm-to-point" 5.0 moments::to_point { arm_to_point(found) }
            /// Arms in millimetres of paper.
            ArmInPaperMm "arm-in-paper-mm" 5.0 moments::in_paper_mm {
                arm_in_paper_mm(found, scale)
                arms_in_paper_mm(scale)
            }
            /// What a joint does to one link handed on to the other without being reversed.
            ReactionNotReversed "reaction-not-reversed" 6.0 polygons::not_reversed { reaction_not_reversed(force) }
            /// A force found negative laid off as if it were positive.
            NegativeTangentialKept "negative-tangential-kept" 5.0 polygons::negative_kept {
                negative_tangential_kept(force)
            }
            /// The part along a link drawn across it.
            NormalAcross "normal-across" 3.0 polygons::normal_across { normal_across(force) }
            /// A force left out of a polygon.
            ForceMissingInPolygon "force-missing-in-polygon" 5.0 polygons::missing { force_missing_in_polygon(force) }
            /// A force laid off twice in a polygon.
            ForceTwice "twice" 3.0 polygons::twice { force_twice(force) }
            /// What a guide does drawn along the guide.
            GuideReactionAlongRod "guide-reaction-along-rod" 3.0 polygons::along_guide {
                guide_reaction_along_rod(force, guide)
            }
            /// What a guide does taken to act in the slider's point.
            GuideReactionThroughPin "guide-reaction-through-pin" 4.0 polygons::through_pin {
                guide_reaction_through_pin(guide, point)
            }
            /// A mass in place of a weight, or a factor of 1000 between units.
            MassForWeight "mass-for-weight" 5.0 forces::mass_for_weight {
                mass_for_weight(load)
                factor_of_thousand(load)
            }
            /// Moments taken about a point through which the lines of the other unknowns do not pass.
            MomentAboutWrongPoint "moment-about-wrong-point" 15.0 moments::about_wrong_point {
                moment_about_wrong_point(found, wrong, right)
                /// About which one the values leave open.
                moment_about_another_point(found, right)
            }
            /// Forces put on the velocity plan as it is, not turned.
            LeverNotTurned "lever-not-turned" 4.0 moments::not_turned { lever_not_turned(found) }
            /// A couple added to the moments of a lever as it is.
            CoupleOnLeverUnscaled "couple-on-lever-unscaled" 4.0 moments::couple_unscaled {
                couple_on_lever_unscaled(link)
            }
            /// The torque of a drive with the sense of what it works against.
            TorqueSense "torque-sense" 5.0 polygons::torque_sense { torque_sense(found) }
            /// Wheels that touch outside taken to turn alike, or a ring and the wheel in it to turn opposite ways.
            MeshSense "mesh-sense" 12.0 teeth::sense {
                mesh_sense(first, second)
                mesh_sense_internal(first, second)
            }
            /// The ratio of teeth taken for the rates themselves, not for those relative to the carrier.
            ArmForgotten "arm-forgotten" 6.0 teeth::arm_forgotten { arm_forgotten(first, second, arm) }
            /// The rate of a wheel relative to its carrier in place of that to the frame.
            RelativeForAbsolute "relative-for-absolute" 5.0 teeth::relative { relative_for_absolute(rate, arm) }
            /// The teeth of a wheel between two others in the ratio of these.
            IdlerCounted "idler-counted" 5.0 teeth::idler_counted { idler_counted(idler, first, last) }
            /// The pitch point of a ring on the near side of the wheel in it.
            PitchPointOnWrongSide "pitch-point-on-wrong-side" 4.0 teeth::wrong_side { pitch_on_wrong_side(wheel, ring) }
            /// The other rim of a wheel with two.
            RimOfCompoundSwapped "rim-of-compound-swapped" 4.0 teeth::rim_swapped {
                rim_swapped(wheel, other)
                /// In both meshes.
                rims_swapped(wheel)
            }
            /// The accelerations of two wheels taken as equal where they touch.
            AccelerationsEqualAtP "accelerations-equal-at-P" 9.0 teeth::accelerations_equal {
                accelerations_equal(first, second)
            }
            /// The diameter of a wheel in place of its radius.
            DiameterForRadius "diameter-for-radius" 4.0 radii::diameter { diameter_for_radius(found, wheel) }
            /// The force between teeth taken along the tangent alone.
            RadialForceLeftOut "radial-force-left-out" 6.0 radii::radial { radial_force_left_out(force) }
            /// The distance of the centres of profiles that touch taken as one of their radii.
            RollerRadiusLeftOut "roller-radius-left-out" 6.0 contacts::radius_left_out {
                radius_left_out(length, link)
            }
            /// A contact's normal drawn from another point than the centre of curvature.
            WrongCentreOfCurvature "wrong-centre-of-curvature" 5.0 contacts::wrong_center {
                wrong_center_of_curvature(wrong, right, first, second)
            }
            /// The velocity along the tangent of profiles that touch left out.
            SlidingLeftOut "sliding-left-out" 5.0 contacts::sliding_left_out { sliding_left_out(image, start) }
            /// A flat face taken along a wrong line.
            FaceAlongWrongLine "face-along-wrong-line" 5.0 contacts::face_along_wrong_line {
                face_along_wrong_line(link, line)
                face_normal_to_wrong_line(link, line)
            }
            /// Friction in the sense of the motion.
            FrictionSense "friction-sense" 6.0 friction::reversed { friction_sense(friction) }
            /// The angle of friction for its tangent or its sine, or these for each other.
            AngleForCoefficient "angle-for-coefficient" 2.0 friction::angle_for_coefficient {
                angle_for_coefficient(friction)
            }
            /// Friction by what a joint would carry without friction.
            NormalWithoutLean "normal-without-lean" 4.0 friction::without_lean { normal_without_lean(friction) }
            /// A circle of friction by the diameter of the journal.
            FrictionCircleDiameter "friction-circle-diameter" 4.0 friction::diameter { friction_circle_diameter(friction) }
            /// Friction left out.
            FrictionLeftOut "friction-left-out" 6.0 friction::left_out { friction_left_out(friction) }
            /// The other assembly mode.
            OtherMode "other-mode" 4.0 lengths::other_mode { other_mode() }
            /// The mechanism drawn at another angle of its crank.
            CrankAngle "crank-angle" 3.0 lengths::crank_angle {
                crank_angle(link, wrong, right)
                /// Its degrees taken for radians.
                crank_angle_in_radians(link, wrong, right)
            }
            /// Two numbers swapped.
            Swapped "swapped" 3.0 copying::swapped { swapped(first, second) }
            /// Digits transposed.
            DigitsTransposed "digits-transposed" 8.0 copying::transposed { digits_transposed(quantity, written, meant) }
            /// A decimal slipped.
            DecimalSlipped "decimal-slipped" 8.0 copying::decimal { decimal_slipped(quantity, written, meant) }
            /// All values cut off in place of rounded.
            Truncated "truncated" 1.0 copying::truncated { truncated() }
            /// The wrong unit written beside a value.
            WrongUnit "wrong-unit" 5.0 copying::unit { wrong_unit(quantity, number, wrong, right) }
            /// A value in another unit of length than the scene's, or where millimetres of paper are asked for, and no unit beside it.
            OtherUnit "other-unit" 3.0 copying::other_unit {
                other_unit(quantity, number, unit, own)
                /// All values of a kind.
                all_in_other_unit(values, first, unit, own)
                value_for_paper(quantity, number, unit, scale, mm)
                /// All of a sheet.
                values_for_paper(segments, unit, scale)
            }
            /// All values of a kind too large or too small by one factor.
            CommonFactor "common-factor" 5.0 copying::common_factor {
                common_factor_degrees(values, first, factor)
                common_factor_turns(values, first, factor)
                common_factor_rpm(values, first, factor)
                common_factor_minutes(values, first, factor)
                common_factor_units(values, first, factor)
            }
            /// A value wrong for a reason that the catalogue does not know, and used in later operations.
            Unknown "unknown" 10.0 unknown::everywhere {
                unknown(quantity)
                /// Nothing else is off.
                unknown_alone(quantity)
                /// More is off, and whether it follows is not known.
                unknown_first(quantity)
            }
        }
    };
}

pub(super) use catalogue;
