package org.phrenic.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URL;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.cage.RibAxisTable;
import org.phrenic.anatomy.virtual.VirtualThoraxParameters;

/** Files of the program itself. */
class ShippedFileTest {
    /** The program after its jar was replaced: its classes are there, its data are not. */
    private static final class WithoutData extends ClassLoader {
        WithoutData() {
            super(ShippedFileTest.class.getClassLoader());
        }

        @Override
        protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
            if (!name.startsWith("org.phrenic.")) {
                return super.loadClass(name, resolve);
            }
            Class<?> known = findLoadedClass(name);
            if (known != null) {
                return known;
            }
            try (InputStream in = getParent().getResourceAsStream(name.replace('.', '/') + ".class")) {
                byte[] code = in.readAllBytes();
                return defineClass(name, code, 0, code.length);
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }

        @Override
        public URL getResource(String name) {
            return name.contains("/data/") ? null : super.getResource(name);
        }
    }

    @Test
    void aFileThatIsMissingIsAFaultOfTheProgram() {
        assertThat(ShippedFile.find("none.txt")).isEmpty();
        assertThatThrownBy(() -> ShippedFile.text("none.txt"))
                .isInstanceOf(ShippedFileException.class)
                .hasMessage("data/none.txt is missing from the program");
    }

    @Test
    void aKnownNameWithoutItsFileIsNoFaultOfTheName() throws ReflectiveOperationException {
        WithoutData loader = new WithoutData();
        for (String[] known : new String[][] {
            {VirtualThoraxParameters.class.getName(), "adult-male", "data/thorax/adult-male.yaml"},
            {RibAxisTable.class.getName(), RibAxisTable.WILSON_CT, "data/ribs/axes-wilson-ct.csv"},
            {RibAxisTable.class.getName(), RibAxisTable.NECK, "data/ribs/axes-neck.csv"}
        }) {
            var preset = loader.loadClass(known[0]).getMethod("preset", String.class);
            assertThatThrownBy(() -> preset.invoke(null, known[1]))
                    .hasRootCauseMessage(known[2] + " is missing from the program");
        }
    }
}
