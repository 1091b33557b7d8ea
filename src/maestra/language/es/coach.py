"""Spanish: what the coach says."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

PHRASES: Final[Mapping[str, tuple[str, ...]]] = MappingProxyType(
    {
        "welcome": (
            "Hola. Vamos a jugar juntos.",
            "Me alegro de verle. Empezamos.",
            "Le doy la bienvenida. El tablero está listo.",
            "Hola de nuevo. Este es nuestro ejercicio.",
        ),
        "your-turn": (
            "Le toca a usted.",
            "Puede empezar cuando quiera.",
            "Por favor, coja una ficha.",
            "La siguiente es suya.",
        ),
        "complete": (
            "El ejercicio está completo. ¡Muy bien!",
            "Era la última. ¡Bravo!",
            "La fila está terminada. ¡Qué buena partida!",
            "Todo está en su sitio. ¡Enhorabuena!",
        ),
        "goodbye": (
            "Esto es todo por hoy. Gracias por jugar.",
            "Lo dejamos aquí. Ha sido un placer jugar con usted.",
            "Terminamos aquí. Hasta pronto.",
            "Gracias por su tiempo. Hasta la próxima.",
        ),
        "paused": (
            "Vamos a descansar un rato.",
            "Hacemos una pequeña pausa.",
            "Ahora un descanso.",
            "Paramos un momento.",
        ),
        "resumed": (
            "Seguimos donde estábamos.",
            "Vamos otra vez.",
            "Se acabó la pausa. Continuamos.",
            "Ahora seguimos.",
        ),
        "board-lost": (
            "Un momento, por favor.",
            "Espere un poco, por favor.",
            "Necesito un momentito.",
            "Esperemos un momento.",
        ),
        "board-back": (
            "Gracias por esperar.",
            "Ya puedo seguir.",
            "Aquí estoy de nuevo.",
            "Ya veo el tablero otra vez.",
        ),
        "may-stop": (
            "La fila puede quedarse así. También puede seguir.",
            "Este podría ser el final. Caben más fichas.",
            "Puede parar aquí. Puede poner otra.",
            "Así está bien. También puede añadir más.",
        ),
        "not-yet": (
            "Todavía queda algo por mover.",
            "Falta un poquito.",
            "Ya casi estamos.",
            "Aún falta algo en la fila.",
        ),
        "let-us-go-on": (
            "Seguimos con la siguiente.",
            "Vamos a por la siguiente.",
            "Continuamos con otra ficha.",
            "Miremos la siguiente.",
        ),
        "accepted": (
            "Así también está bien.",
            "Lo dejamos así.",
            "Bien, se queda ahí.",
            "De acuerdo, puede quedarse.",
        ),
        "praise": (
            "¡Muy bien!",
            "Sí, ahí encaja.",
            "¡Estupendo!",
            "Eso es.",
            "Perfecto, ese es su sitio.",
            "Qué bien, siga así.",
        ),
        "praise-own-correction": (
            "Ahora encaja. ¡Muy bien!",
            "La ha encontrado. ¡Estupendo!",
            "Eso es. ¡Bien pensado!",
            "Ese es su sitio. ¡Genial!",
        ),
        "thanks-for-putting-back": (
            "Gracias. Probemos con otra.",
            "Bien. Miremos otra vez.",
            "Gracias. ¿Cuál podría ser?",
            "De acuerdo. Volvamos a mirar.",
        ),
        "refused": (
            "Buen intento. {reason}",
            "Miremos otra vez. {reason}",
            "Casi. {reason}",
            "Echemos otro vistazo. {reason}",
            "Pensemos juntos. {reason}",
        ),
        "refused-by-caregiver": (
            "Probemos otra aquí.",
            "Aquí encaja mejor otra.",
            "Busquemos otra.",
            "Intentemos una distinta.",
        ),
        "please-put-back": (
            "Por favor, devuelva {token} {place:to}.",
            "{token} vuelve {place:to}.",
            "¿Puede devolver {token} {place:to}?",
            "Llevemos {token} de vuelta {place:to}.",
        ),
        "i-put-back": (
            "Yo devuelvo {token} a su sitio.",
            "Déjeme devolver {token}.",
            "Yo me llevo {token} de vuelta.",
            "Pongo {token} otra vez en su casilla.",
        ),
        "help-comes": (
            "Alguien nos va a ayudar.",
            "Esperemos una mano amiga.",
            "He pedido un poco de ayuda.",
            "La ayuda está en camino.",
        ),
        "one-at-a-time": (
            "Cojamos las fichas de una en una.",
            "Una después de otra, por favor.",
            "Solo una ficha a la vez, por favor.",
            "Movamos una sola ficha.",
        ),
        "unknown-token": (
            "No conozco esta ficha. Dejémosla a un lado.",
            "Esta ficha es nueva para mí. Apártela, por favor.",
            "Esta es de otro juego.",
            "Esta ficha no nos hace falta.",
        ),
        "encourage": (
            "Tómese su tiempo.",
            "Lo está haciendo bien.",
            "No hay ninguna prisa.",
            "Seguro que hay una.",
            "Miremos con calma.",
        ),
        "remind": (
            "Recuerde: {rule}",
            "La idea es esta: {rule}",
            "Esto es lo que hacemos: {rule}",
            "Se lo digo otra vez: {rule}",
        ),
        "look-at-row": (
            "Mire {row}.",
            "Hay una que encaja en {row}.",
            "Vamos a mirar {row}.",
            "Puede encontrarla en {row}.",
        ),
        "one-of-these": (
            "Podría ser {tokens}.",
            "Una de estas encaja: {tokens}.",
            "¿Será {tokens}?",
            "¿Cuál es: {tokens}?",
        ),
        "this-one": (
            "{token} encaja en {place}.",
            "Pongamos {token} en {place}.",
            "Puede poner {token} en {place}.",
            "{token} puede ir {place:to}.",
        ),
        "together": (
            "¿Ponemos juntos {token} en {place}?",
            "Juntos ponemos {token} en {place}.",
            "Llevemos juntos {token} {place:to}.",
            "Movamos {token} {place:to} entre los dos.",
        ),
        "i-place": (
            "Yo pongo {token} en {place}.",
            "Déjeme poner {token} en {place}.",
            "Yo llevo {token} {place:to}.",
            "Esta la hago yo: {token} en {place}.",
        ),
        "i-cannot": (
            "No llego hasta ahí.",
            "Mi brazo no alcanza.",
            "Este movimiento me cuesta.",
            "Esta no la puedo mover.",
        ),
        "i-am-here": (
            "Estoy aquí con usted.",
            "Estoy mirando con usted.",
            "Tenemos todo el tiempo del mundo.",
            "Sigo a su lado.",
        ),
        "show-me": (
            "Enséñeme cómo va.",
            "Por favor, juéguelo una vez para mí.",
            "Estoy mirando. Empiece, por favor.",
            "Por favor, enséñeme una partida correcta.",
        ),
        "seen": (
            "Lo he visto.",
            "Gracias, me he fijado bien.",
            "Bien, esta ya la tengo.",
            "Lo recordaré.",
        ),
        "show-another": (
            "Por favor, enséñeme otra.",
            "Una más me ayudaría.",
            "¿Puede jugarlo una vez de otra manera?",
            "Por favor, juéguelo con otras fichas.",
        ),
        "clear-the-row": (
            "Por favor, vacíe la fila para la siguiente.",
            "Devuelva las fichas a cualquier casilla del almacén.",
            "Ahora necesitamos la fila vacía.",
            "Por favor, deje libre la fila de destino.",
        ),
        "taken-back": (
            "De acuerdo, ese no cuenta.",
            "Olvido este movimiento.",
            "Bien, lo deshacemos.",
            "Muy bien, como si nada.",
        ),
        "nothing-shown": (
            "Mueva primero una ficha, por favor.",
            "Todavía no he visto ningún movimiento.",
            "Aún no hay nada de lo que aprender.",
            "Me falta ver un movimiento.",
        ),
        "forgotten": (
            "De acuerdo, olvido esta partida.",
            "Esta partida no cuenta.",
            "Esta la dejamos fuera.",
            "Borro lo que acabo de ver.",
        ),
        "understood": (
            "Esto es lo que entiendo: {rules}",
            "Hasta ahora entiendo esto: {rules}",
            "Yo lo veo así: {rules}",
            "Según lo entiendo: {rules}",
        ),
        "not-clear": (
            "Todavía no lo tengo del todo claro.",
            "Aún no estoy seguro.",
            "Me quedan dudas.",
            "Se puede entender de varias maneras.",
        ),
        "learned": (
            "Gracias, he aprendido el ejercicio.",
            "Ahora sé cómo va.",
            "Ya puedo jugarlo con otras personas.",
            "Tengo claro el ejercicio.",
        ),
        "thanks": (
            "Gracias.",
            "Gracias, eso me ayuda.",
            "Es bueno saberlo.",
            "Entiendo, gracias.",
        ),
    }
)

ASKED: Final[Mapping[str, str]] = MappingProxyType(
    {
        "put-back": "Por favor, devuelva a su sitio o haga devolver: {tokens}.",
        "check-board": "Por favor, revise el tablero: las fichas no están como deberían.",
        "place": "Por favor, ponga {token} en {place}.",
        "no-way-on": "Ya no hay ningún movimiento correcto. Por favor, termine la sesión o juzgue "
        "de otra manera el último movimiento.",
        "long-silence": "Hace mucho que nadie mueve. ¿Quiere hacer una pausa?",
        "demonstration": "No he podido aprender de esta partida. Por favor, enséñela otra vez.",
    }
)
