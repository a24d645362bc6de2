package org.phrenic.model.material;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import org.junit.jupiter.api.Test;
import org.phrenic.model.assembly.NodeMasses;
import org.phrenic.model.organ.SpringList;

/** Light nodes get just the mass that the step asks for, and no others any. */
class MassScalingTest {
    private static final double STEP_S = 1e-3;
    private static final double STIFFNESS = 50;
    private static final double EXACT = 1e-12;
    private static final double[] TWO_NODES = {0, 0, 0, 3, 4, 0};

    private static MassScaling scaling() {
        MassScaling scaling = new MassScaling(TWO_NODES);
        SpringList springs = new SpringList();
        springs.add(0, 1, STIFFNESS, 5, 0);
        scaling.addSprings(springs);
        return scaling;
    }

    @Test
    void twoEqualNodesOnASpringComeToTheLimitOfVerlet() {
        double[] mass = new NodeMasses(new double[] {1e-6, 1e-6}, scaling().leastMasses(STEP_S)).all();
        // ω² = 2 k / m for two equal masses, and Verlet's limit is ω h = 2.
        double omega = Math.sqrt(2 * STIFFNESS / mass[0]);
        assertThat(omega * STEP_S).isCloseTo(2, offset(EXACT));
        assertThat(mass[1]).isEqualTo(mass[0]);
    }

    @Test
    void heavyNodesStayAsTheyAre() {
        NodeMasses masses = new NodeMasses(new double[] {1e-3, 1e-3}, scaling().leastMasses(STEP_S));
        assertThat(masses.all()).containsExactly(1e-3, 1e-3);
        assertThat(masses.addedPercent()).isZero();
    }

    @Test
    void tissueThatGrowsHeavierOutweighsItsLeastMassOnlyBeyondIt() {
        double least = scaling().leastMasses(STEP_S)[0];
        NodeMasses masses = new NodeMasses(new double[] {0.5 * least, 0.5 * least}, new double[] {least, least});
        assertThat(masses.addedPercent()).isCloseTo(100, offset(EXACT));
        assertThat(masses.of(0, 1.5, 1, 1)).isEqualTo(least);
        assertThat(masses.of(0, 4, 1, 1)).isCloseTo(2 * least, offset(EXACT * least));
    }

    @Test
    void aNodeOnBoneAloneComesToTheLimitOfItsOwnFrequency() {
        MassScaling scaling = new MassScaling(TWO_NODES);
        double factor = 0.25;
        scaling.addAttachments(new int[] {0}, new double[] {STIFFNESS}, factor);
        double[] least = scaling.leastMasses(STEP_S);
        // ω² = k / m against a fixed anchor.
        assertThat(Math.sqrt(factor * STIFFNESS / least[0]) * STEP_S).isCloseTo(2, offset(EXACT));
        assertThat(least[1]).isZero();
    }

    /** Two springs at a right angle that a fold lays side by side are one spring of twice the stiffness. */
    @Test
    void aNodeThatIsStableInAnyShapeBearsSpringsLaidSideBySide() {
        MassScaling open = new MassScaling(new double[] {0, 0, 0, 5, 0, 0, 0, 5, 0});
        MassScaling folded = new MassScaling(new double[] {0, 0, 0, 5, 0, 0, 5, 0, 0});
        for (MassScaling scaling : new MassScaling[] {open, folded}) {
            SpringList springs = new SpringList();
            springs.add(0, 1, STIFFNESS, 5, 0);
            springs.add(0, 2, STIFFNESS, 5, 0);
            scaling.addSprings(springs);
            scaling.addAttachments(new int[] {0}, new double[] {STIFFNESS}, 1);
        }
        double most = folded.leastMasses(STEP_S)[0];
        assertThat(open.leastMasses(STEP_S)[0]).isLessThan(0.61 * most);
        assertThat(open.leastMassForAnyShape(0, STEP_S)).isCloseTo(most, offset(EXACT * most));
        assertThat(folded.leastMassForAnyShape(0, STEP_S)).isCloseTo(most, offset(EXACT * most));
    }
}
