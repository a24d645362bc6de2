package org.phrenic.ui.access.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.access.attempt.NeedleAngles;
import org.phrenic.access.attempt.NeedleLoad;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.ultrasound.BModeImage;
import org.phrenic.access.ultrasound.CurvilinearProbe;
import org.phrenic.access.ultrasound.ProbePose;
import org.phrenic.access.ultrasound.Ultrasound;
import org.phrenic.access.ultrasound.UltrasoundSettings;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.Vectors;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.ui.access.UltrasoundShot;
import org.phrenic.ui.session.EventThread;

/** The line in the ultrasound image along which the needle points. */
class UltrasoundViewTest {
    private static final double TRUNK_MM = 200;
    private static final ProbePose POSE =
            new ProbePose(new double[] {2, 100, 100}, new double[] {1, 0, 0}, new double[] {0, 0, 1});
    /** In the image plane, to the side of the sector, toward its middle. */
    private static final double[] ENTRY = {2, 100, 30};

    private static final double[] ALONG = Vectors.normalize(Vectors.of(1, 0, 1));
    /** Of the line, from the entry, beside the sector; the sector begins at 30 mm. */
    private static final int BESIDE_MM = 26;

    private static final int WITHIN_FROM_MM = 34;
    private static final int WITHIN_TO_MM = 80;
    private static final double BETWEEN_DASHES_AND_DOTS = 0.3;

    private static NeedleState state() {
        double[] target = Vectors.addScaled(ENTRY, ALONG, WITHIN_TO_MM);
        return new NeedleState(
                1,
                RespiratoryPhase.PAUSE,
                target,
                10,
                Optional.of(ENTRY),
                false,
                Vectors.addScaled(ENTRY, ALONG, -150),
                ENTRY,
                0,
                WITHIN_TO_MM,
                false,
                Optional.empty(),
                List.of(),
                5,
                "",
                List.of(),
                0,
                new NeedleAngles(90, 45),
                Optional.empty(),
                NeedleLoad.NONE);
    }

    private static BModeImage image() {
        List<Surface> trunk = List.of(new Surface(
                "skin",
                StructureKind.SKIN,
                0,
                Side.MIDLINE,
                Shapes.box(TRUNK_MM, TRUNK_MM, TRUNK_MM),
                Surface.Motion.STILL,
                new boolean[0]));
        return new Ultrasound(trunk, CurvilinearProbe.abdominal(), 2, Optional.empty())
                .take(Frame.still(trunk), POSE, UltrasoundSettings.DEFAULT.withDepth(90), Optional.empty());
    }

    /** Where no echo can come from, the needle does not appear, however well it lies in the image plane. */
    @Test
    void theGuideIsDottedBesideTheSectorAndDashedInIt() {
        BModeImage image = image();
        int side = BModeImage.SIZE;
        BufferedImage black = new BufferedImage(side, side, BufferedImage.TYPE_BYTE_GRAY);
        BufferedImage painted = new BufferedImage(side, side, BufferedImage.TYPE_INT_RGB);
        EventThread.run(() -> {
            UltrasoundView view = new UltrasoundView();
            view.setSize(side, side);
            view.setOutlined(false);
            view.show(Optional.of(new UltrasoundShot(image, black, state())), "");
            Graphics2D g = painted.createGraphics();
            view.paint(g);
            g.dispose();
        });
        assertThat(share(painted, image, 2, BESIDE_MM)).as("dots").isBetween(0.01, BETWEEN_DASHES_AND_DOTS);
        assertThat(share(painted, image, WITHIN_FROM_MM, WITHIN_TO_MM))
                .as("dashes")
                .isGreaterThan(BETWEEN_DASHES_AND_DOTS);
    }

    /** Share of a part of the line that is painted. */
    private static double share(BufferedImage painted, BModeImage image, int fromMm, int toMm) {
        return IntStream.range(10 * fromMm, 10 * toMm)
                .mapToObj(tenth -> image.pixelOf(Vectors.addScaled(ENTRY, ALONG, 0.1 * tenth)))
                .mapToInt(at -> (painted.getRGB((int) at[0], (int) at[1]) >> 16 & 0xff) > 100 ? 1 : 0)
                .average()
                .orElseThrow();
    }
}
