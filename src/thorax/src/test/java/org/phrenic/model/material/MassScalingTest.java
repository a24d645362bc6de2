package org.phrenic.model.material;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import org.junit.jupiter.api.Test;
import org.phrenic.model.organ.SpringList;

/** Light nodes get just the mass that the step asks for, and no others any. */
class MassScalingTest {
    private static final double STEP_S = 1e-3;
    private static final double STIFFNESS = 50;
    private static final double EXACT = 1e-12;
    private static final double[] TWO_NODES = {0, 0, 0, 3, 4, 0};

    private static MassScaling scaling(double[] mass) {
        MassScaling scaling = new MassScaling(TWO_NODES, mass);
        SpringList springs = new SpringList();
        springs.add(0, 1, STIFFNESS, 5, 0);
        scaling.addSprings(springs);
        return scaling;
    }

    @Test
    void twoEqualNodesOnASpringComeToTheLimitOfVerlet() {
        double[] mass = {1e-6, 1e-6};
        scaling(mass).raiseMassesFor(STEP_S);
        // ω² = 2 k / m for two equal masses, and Verlet's limit is ω h = 2.
        double omega = Math.sqrt(2 * STIFFNESS / mass[0]);
        assertThat(omega * STEP_S).isCloseTo(2, offset(EXACT));
        assertThat(mass[1]).isEqualTo(mass[0]);
    }

    @Test
    void heavyNodesStayAsTheyAre() {
        double[] mass = {1e-3, 1e-3};
        MassScaling scaling = scaling(mass);
        scaling.raiseMassesFor(STEP_S);
        assertThat(mass).containsExactly(1e-3, 1e-3);
        assertThat(scaling.addedPercent()).isZero();
    }

    @Test
    void aNodeOnBoneAloneComesToTheLimitOfItsOwnFrequency() {
        double[] mass = {1e-9, 1};
        MassScaling scaling = new MassScaling(TWO_NODES, mass);
        scaling.addAttachments(new int[] {0}, new double[] {STIFFNESS}, 1);
        scaling.raiseMassesFor(STEP_S);
        // ω² = k / m against a fixed anchor.
        assertThat(Math.sqrt(STIFFNESS / mass[0]) * STEP_S).isCloseTo(2, offset(EXACT));
        assertThat(mass[1]).isEqualTo(1);
    }
}
