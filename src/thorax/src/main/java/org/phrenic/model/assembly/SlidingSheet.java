package org.phrenic.model.assembly;

import java.util.Arrays;
import org.phrenic.anatomy.cage.MovingChestWall;
import org.phrenic.engine.constraint.ContactSurface;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.MassSpringBuilder;

/**
 * Vertices of the sheet in contact with the chest wall.
 *
 * @param vertices of the sheet
 * @param restPositions three numbers per vertex, mm
 * @param wall contact surface of the vertices, in their order
 */
public record SlidingSheet(int[] vertices, double[] restPositions, ContactSurface wall) {
    public static SlidingSheet of(DiaphragmPart diaphragm, MovingChestWall wall, double[] positions) {
        int[] sliding = diaphragm.slidingVertices(wall);
        double[] rest = MassSpringBuilder.positionsOf(positions, diaphragm.firstNode, sliding);
        double[] inset =
                Arrays.stream(sliding).mapToDouble(diaphragm::wallInset).toArray();
        return new SlidingSheet(sliding, rest, wall.limitingContact(rest, inset));
    }
}
