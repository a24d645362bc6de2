package org.phrenic.fit;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.TriangleMesh;

/** A target lies where its part of the body lies, in its size, or it is in another unit or other axes. */
class TargetPlaceTest {
    /** A right lung that reaches over the midline; its diagonal is 290 mm. */
    private static final double[] LUNG = {-130, -80, 0, 13, 80, 200};

    private static final double TENTH = 29;

    private static double[] moved(int axis, double by) {
        double[] box = LUNG.clone();
        box[axis] += by;
        box[3 + axis] += by;
        return box;
    }

    private static double[] scaled(double factor) {
        double[] box = LUNG.clone();
        for (int axis = 0; axis < 3; axis++) {
            double centre = (LUNG[axis] + LUNG[3 + axis]) / 2;
            box[axis] = centre + factor * (LUNG[axis] - centre);
            box[3 + axis] = centre + factor * (LUNG[3 + axis] - centre);
        }
        return box;
    }

    private static FitTarget surface(double... box) {
        return FitTarget.of(FitPart.LUNG_RIGHT, new TriangleMesh(box, new int[] {0, 1, 0}));
    }

    private static FitTarget points(double... box) {
        return FitTarget.ofPointPairs(FitPart.LUNG_RIGHT, box, box);
    }

    private static void takes(FitTarget target) {
        assertThatCode(() -> TargetDistance.requirePlace(target, LUNG)).doesNotThrowAnyException();
    }

    private static void refuses(FitTarget target) {
        assertThatThrownBy(() -> TargetDistance.requirePlace(target, LUNG))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("expected mm in the axes of the body");
    }

    @Test
    void aSurfaceLiesBesideItsPartByATenthOfTheSizeAtMost() {
        for (int axis = 0; axis < 3; axis++) {
            double half = (LUNG[3 + axis] - LUNG[axis]) / 2;
            for (int sign : new int[] {-1, 1}) {
                takes(surface(moved(axis, sign * (half + TENTH - 2))));
                refuses(surface(moved(axis, sign * (half + TENTH + 2))));
            }
        }
    }

    @Test
    void pointsLieBesideTheirPartByATenthOfTheSizeAtMost() {
        for (int axis = 0; axis < 3; axis++) {
            double whole = LUNG[3 + axis] - LUNG[axis];
            for (int sign : new int[] {-1, 1}) {
                takes(points(moved(axis, sign * (whole + TENTH - 2))));
                refuses(points(moved(axis, sign * (whole + TENTH + 2))));
            }
        }
    }

    @Test
    void aSurfaceIsAtMostFiveTimesAsLargeOrSmall() {
        takes(surface(scaled(4.5)));
        takes(surface(scaled(1 / 4.5)));
        refuses(surface(scaled(5.5)));
        refuses(surface(scaled(1 / 5.5)));
    }

    /** The medial faces of the lungs of one body meet: the boxes of a lung and its mirror image overlap. */
    @Test
    void aMirroredLungIsRefused() {
        refuses(surface(-LUNG[3], LUNG[1], LUNG[2], -LUNG[0], LUNG[4], LUNG[5]));
    }

    @Test
    void aPartOfALungIsTaken() {
        takes(surface(LUNG[0], LUNG[1], LUNG[2] - 60, LUNG[3], LUNG[4], LUNG[2] + 10));
        double[] whole = {LUNG[0], LUNG[1], LUNG[2] - 300, LUNG[3], LUNG[4], LUNG[5]};
        takes(surface(whole));
    }
}
