package org.phrenic.ui.view;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ViewedBodyTest {
    private static final double[] BOUNDS = {-190, -130, 0, 180, 120, 420};

    /** Two persons may be of one size. */
    @Test
    void aBodyIsToldFromOthersByNameAndSize() {
        ViewedBody man = new ViewedBody("virtual/adult-male", BOUNDS);
        double[] nearly = BOUNDS.clone();
        nearly[0] -= 5;
        assertThat(man.isAlso(new ViewedBody("virtual/adult-male", nearly))).isTrue();
        assertThat(man.isAlso(new ViewedBody("virtual/adult-female", nearly))).isFalse();
        double[] larger = BOUNDS.clone();
        larger[5] += 300;
        assertThat(man.isAlso(new ViewedBody("virtual/adult-male", larger))).isFalse();
    }
}
