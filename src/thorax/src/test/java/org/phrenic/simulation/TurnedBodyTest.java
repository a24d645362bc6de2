package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.assertj.core.data.Percentage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.cage.RibAxisTable;
import org.phrenic.anatomy.cage.RibCage;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.engine.kinematics.HelicalAxis;
import org.phrenic.engine.kinematics.RigidMotion;

/**
 * A body that lies turned by 15 degrees about its long axis breathes as it does when it lies straight. Only rounding
 * and the orientation of the mesh relative to the axes differ. With ribs, tendon and regions along the axes of the scan
 * the right dome of the man goes 15 % less far.
 */
class TurnedBodyTest {
    private static final double TURN_DEG = 15;
    private static final double INSPIRED_S = 1.6;
    private static final Percentage SAME_BREATH = Percentage.withPercentage(1);
    private static final double OF_THE_LIVERS_WAY = 0.02;
    private static final double SAME_ANGLE_DEG = 0.3;

    private static RigidMotion turn() {
        double c = StrictMath.cos(StrictMath.toRadians(TURN_DEG));
        double s = StrictMath.sin(StrictMath.toRadians(TURN_DEG));
        return RigidMotion.of(new double[] {c, -s, 0, s, c, 0, 0, 0, 1}, new double[] {20, -35, 10});
    }

    private static Thorax turned(Thorax body) {
        return new Thorax(
                body.name(),
                body.structures().stream()
                        .map(s -> {
                            double[] p = s.mesh().positions().clone();
                            turn().apply(p);
                            return s.withMesh(s.mesh().withPositions(p));
                        })
                        .toList(),
                body.notes());
    }

    @ParameterizedTest
    @ValueSource(strings = {"material=physical", "material=published"})
    void bothDomesCageAndLiverGoAsFar(String material) {
        String[] settings = Runs.sheetAlone(material);
        Runs.Run straight = Runs.run(INSPIRED_S, Runs.scenario(settings), Runs.male());
        Runs.Run turned = Runs.run(INSPIRED_S, Runs.scenario(settings), turned(Runs.male()));
        for (String column : new String[] {"dome_right_mm", "dome_left_mm", "lateral_right_mm", "lateral_left_mm"}) {
            assertThat(turned.fall(column)).as(column).isCloseTo(straight.fall(column), SAME_BREATH);
        }
        for (String column :
                new String[] {"sternum_cranial_mm", "sternum_ventral_mm", "ap_change_mm", "transverse_change_mm"}) {
            assertThat(turned.most(column)).as(column).isCloseTo(straight.most(column), SAME_BREATH);
        }
        double way = straight.most("liver_si_mm");
        for (String column : new String[] {"liver_si_mm", "liver_ap_mm", "liver_lr_mm"}) {
            assertThat(turned.most(column))
                    .as(column)
                    .isCloseTo(straight.most(column), within(OF_THE_LIVERS_WAY * way));
        }
    }

    @Test
    void theRibsTurnAboutTheTurnedAxes() {
        Thorax woman = VirtualThorax.ofPreset("adult-female", Resolution.LOW);
        RibAxisTable table = RibAxisTable.preset(RibAxisTable.WILSON_CT);
        RibCage straight = RibCage.of(woman, table, true);
        RibCage turned = RibCage.of(turned(woman), table, true);
        for (int i = 0; i < straight.bodies().size(); i++) {
            if (straight.bodies().get(i).axis().isEmpty()) {
                continue;
            }
            HelicalAxis expected = straight.bodies().get(i).axis().get().movedBy(turn());
            HelicalAxis found = turned.bodies().get(i).axis().orElseThrow();
            double cosine = expected.directionX() * found.directionX()
                    + expected.directionY() * found.directionY()
                    + expected.directionZ() * found.directionZ();
            assertThat(StrictMath.toDegrees(StrictMath.acos(Math.min(1, cosine))))
                    .as(straight.bodies().get(i).name())
                    .isLessThan(SAME_ANGLE_DEG);
            assertThat(found.angle()).isCloseTo(expected.angle(), within(1e-3));
        }
    }
}
