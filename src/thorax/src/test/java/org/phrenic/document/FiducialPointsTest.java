package org.phrenic.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.BadInputException;

/** Fiducials of 3D Slicer are a table in LPS, wherever a table of points is read. */
class FiducialPointsTest {
    private static final String POINTS =
            """
            # Markups fiducial file version = 4.11
            # CoordinateSystem = LPS
            # columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID
            1,-12.5,30,440.25,0,0,0,1,1,1,0,"dome, right",top,

            2,1,2,3e1,0,0,0,1,1,1,0,F-2,,,2,0
            """;

    @TempDir
    private Path folder;

    private CsvTable read(String text) throws IOException {
        return CsvTable.read(Files.writeString(folder.resolve("points.fcsv"), text));
    }

    @Test
    void pointsComeInLpsWhateverAxesTheFileNames() throws IOException {
        CsvTable table = read(POINTS);
        assertThat(table.texts("name")).containsExactly("dome, right", "F-2");
        assertThat(table.numbers("x_mm")).containsExactly(-12.5, 1);
        assertThat(table.numbers("y_mm")).containsExactly(30, 2);
        assertThat(table.numbers("z_mm")).containsExactly(440.25, 30);
        assertThat(read(POINTS.replace("= LPS", "= 1")).numbers("x_mm")).containsExactly(-12.5, 1);
        for (String ras : new String[] {"# CoordinateSystem = RAS\n", "# CoordinateSystem = 0\n", ""}) {
            CsvTable turned = read(POINTS.replace("# CoordinateSystem = LPS\n", ras));
            assertThat(turned.numbers("x_mm")).containsExactly(12.5, -1);
            assertThat(turned.numbers("y_mm")).containsExactly(-30, -2);
            assertThat(turned.numbers("z_mm")).containsExactly(440.25, 30);
        }
    }

    /** Slicer 5 writes 0, 0, 0 for a point that has no position yet; its status is 0, 1 or 3. */
    @Test
    void pointsWithoutADefinedPositionAreLeftOut() throws IOException {
        for (String status : new String[] {"0", "1", "3"}) {
            assertThat(read(POINTS.replace("F-2,,,2,0", "F-2,,," + status + ",0"))
                            .texts("name"))
                    .containsExactly("dome, right");
        }
        assertThat(read(POINTS.replace("F-2,,,2,0", "F-2,,")).texts("name")).containsExactly("dome, right", "F-2");
    }

    @Test
    void theOldOrderOfColumnsIsReadByTheirNames() throws IOException {
        CsvTable table = read("# columns = label,x,y,z,sel,vis\nL1,5,6,7,1,1\n");
        assertThat(table.texts("name")).containsExactly("L1");
        assertThat(table.numbers("x_mm")).containsExactly(-5);
        assertThat(table.numbers("z_mm")).containsExactly(7);
    }

    @Test
    void otherTextIsRefusedWithItsLine() {
        assertThatThrownBy(() -> read(POINTS.replace("= LPS", "= IJK")))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("line 2: found the axes 'IJK', expected LPS or RAS");
        assertThatThrownBy(() -> read(POINTS.replace("3e1", "high")))
                .hasMessageContaining("line 6: found 'high', expected three coordinates");
        assertThatThrownBy(() -> read("x,y\n1,2\n")).hasMessageContaining("line 1: found 'y'");
        assertThatThrownBy(() -> read(POINTS.replace("right\"", "right")))
                .hasMessageContaining("line 4: found a quoted cell that is broken");
    }
}
