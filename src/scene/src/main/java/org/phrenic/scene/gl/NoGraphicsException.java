package org.phrenic.scene.gl;

import java.util.Arrays;

/** Thrown if no OpenGL 3.3 context is available. The message is one sentence that names what is missing. */
public final class NoGraphicsException extends Exception {
    private static final long serialVersionUID = 1;

    public NoGraphicsException(String sentence) {
        super(sentence);
    }

    public NoGraphicsException(String sentence, Throwable cause) {
        super(sentence, cause);
    }

    /** A library of the system is missing; JOGL's own depend on it. */
    static NoGraphicsException missingLibrary(UnsatisfiedLinkError error) {
        String message = String.valueOf(error.getMessage());
        // A method in quotes: its library was never loaded, for JOGL found no place for it.
        if (message.startsWith("'")) {
            return new NoGraphicsException(
                    "No pictures can be made here: JOGL could not unpack its libraries into the temporary folder "
                            + System.getProperty("java.io.tmpdir")
                            + ", expected one that can be written and that programs may run from",
                    error);
        }
        String library = Arrays.stream(message.split(": "))
                .map(part -> part.substring(part.lastIndexOf('/') + 1))
                .filter(part -> part.matches("[\\w.+-]+\\.so[.\\d]*"))
                .reduce((first, last) -> last)
                .orElse(message);
        return missingLibrary(library, error);
    }

    /** @param cause null for none */
    static NoGraphicsException missingLibrary(String library, Throwable cause) {
        return new NoGraphicsException(
                "No pictures can be made here: the library " + library
                        + " is missing, which JOGL needs with an X server and without",
                cause);
    }
}
