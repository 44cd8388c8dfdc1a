/**
 * Networks that read a body's damping ratio and natural frequency from short-time Fourier images of how it and its seat move
 * (chapter 8 of the thesis), and what they are measured against. Only {@code Engine}, {@code Layers}, {@code TimePooling},
 * {@code Steps}, {@code Training} and {@code Reader} know DJL; nothing else of wbv loads it.
 */
package wbv.network;
