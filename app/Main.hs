{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Main
-- Description : The command line
--
-- From options to one call.
module Main
  ( main,
  )
where

import Control.Applicative (optional, some, (<|>))
import Control.Exception (SomeAsyncException, SomeException, fromException, handle, throwIO)
import Data.Maybe (fromMaybe)
import qualified Data.Text as Text
import qualified Data.Text.IO as Text
import Data.Version (showVersion)
import Dioptre.Command.Check (Format (..), check)
import Dioptre.Command.Compare (compare)
import Dioptre.Command.Info (info)
import Dioptre.Command.Journal (newJournal)
import Dioptre.Command.Render (Options (..), Output (..), render)
import Dioptre.Command.Run (firstNumber, readConfiguration, run)
import Dioptre.Files.Number (PictureNumber)
import Dioptre.Scene.Configuration (Configuration (..))
import Dioptre.Source.Language (Language (..), fromLocale, inLanguage, languageNames)
import Dioptre.Syntax.Value (integer)
import GHC.Conc (getNumProcessors, setNumCapabilities)
import GHC.IO.Encoding (mkTextEncoding, setFileSystemEncoding, setLocaleEncoding)
import GHC.IO.Exception (IOErrorType (ResourceVanished), ioe_type)
import Options.Applicative hiding (info, optional, some, (<|>))
import qualified Options.Applicative as Options
import Paths_dioptre (version)
import System.Environment (getArgs, getEnvironment)
import System.Exit (ExitCode (..), exitWith)
import System.IO (hPutStrLn, hSetEncoding, stderr, stdout, utf8)
import Prelude hiding (compare)

-- | What to do, with the options that every command has.
data Command = Command
  { commandSettings :: Settings,
    commandWork :: Work
  }

-- | How to speak, and how many processors to use.
data Settings = Settings
  { settingLanguage :: Maybe Language,
    settingQuiet :: Bool,
    settingThreads :: Maybe Int
  }

data Work
  = Configured
  | Render (PictureNumber -> Options)
  | Check Format [FilePath]
  | Compare FilePath FilePath
  | Info

main :: IO ()
main = do
  -- Before anything is read or said: UTF-8, whatever the locale; names of files keep their bytes.
  mkTextEncoding "UTF-8//ROUNDTRIP" >>= setFileSystemEncoding
  setLocaleEncoding utf8
  mapM_ (`hSetEncoding` utf8) [stdout, stderr]
  handle bug $ do
    configuration <- readConfiguration
    environment <- getEnvironment
    let locale = fromLocale (`lookup` environment)
        configured = either (const Nothing) (\(_, c, _) -> configurationLanguage c) configuration
        habitual = fromMaybe locale configured
    asked <- getArgs >>= handleParseResult . execParserPure defaultPrefs (program habitual) . joinCrop
    let settings = commandSettings asked
        l = fromMaybe habitual (settingLanguage settings)
        first = either (const minBound) (\(_, c, _) -> firstNumber c) configuration
    maybe getNumProcessors pure (settingThreads settings) >>= setNumCapabilities
    journal <- newJournal l (not (settingQuiet settings))
    exitWith =<< case commandWork asked of
      Configured -> run journal configuration
      Render options -> render journal (options first)
      Check format paths -> check journal format paths
      Compare a b -> compare journal a b
      Info -> ExitSuccess <$ Text.putStr (info l)

-- | The four numbers of @--crop@ as one argument, which is what the option parser can take.
joinCrop :: [String] -> [String]
joinCrop arguments = case arguments of
  "--crop" : rest | (numbers@[_, _, _, _], others) <- splitAt 4 rest -> ("--crop=" <> unwords numbers) : joinCrop others
  "--" : rest -> "--" : rest
  other : rest -> other : joinCrop rest
  [] -> []

-- | What was not foreseen is a mistake of ours, and says so; except that whoever stops reading our output, or stops us, means it.
bug :: SomeException -> IO a
bug e
  | Just code <- fromException e = throwIO (code :: ExitCode)
  | Just stop <- fromException e = throwIO (stop :: SomeAsyncException)
  | Just broken <- fromException e, ResourceVanished <- ioe_type broken = exitWith (ExitFailure 141)
  | otherwise = do
    hPutStrLn stderr ("dioptre: this is a bug of ours, please report it / ceci est une erreur de notre part, merci de la signaler\n" <> show e)
    exitWith (ExitFailure 70)

program :: Language -> ParserInfo Command
program l =
  Options.info
    (helpOption <*> versionOption <*> (commands <|> bareScene <|> configured))
    ( fullDesc
        <> failureCode 2
        <> header (say "dioptre - draws the picture that the rays of a scene see" "dioptre - dessine l'image que voient les rayons d'une scène")
        <> progDesc
          ( say
              "Without a command, runs what configuration.cfg says; with the path of a scene, renders it."
              "Sans commande, exécute ce que dit configuration.cfg\xA0; avec le chemin d'une scène, la dessine."
          )
        <> footer
          ( say
              "Exit codes: 0 done, 1 faults under check or --strict, or a difference, 2 wrong usage, 3 a file that cannot be read or written, 70 a bug of ours."
              "Codes de sortie\xA0: 0 terminé, 1 fautes avec check ou --strict, ou une différence, 2 mauvais usage, 3 fichier illisible ou impossible à écrire, 70 erreur de notre part."
          )
    )
  where
    say = inLanguage l
    helpOption = abortOption (ShowHelpText Nothing) (long "help" <> short 'h' <> help (say "show this text" "afficher ce texte") <> hidden)
    versionOption = infoOption ("dioptre " <> showVersion version) (long "version" <> help (say "show the version" "afficher la version") <> hidden)

    commands =
      subparser . mconcat $
        [ entry "render" (say "draw a scene" "dessiner une scène") (rendering <$> renderOptions),
          entry "check" (say "tell what is wrong with scenes, and draw nothing" "dire ce qui ne va pas dans des scènes, sans dessiner") (checking <$> settings <*> format <*> some scene),
          entry "compare" (say "compare two scenes or pictures, pixel by pixel" "comparer deux scènes ou images, pixel par pixel") (comparing <$> settings <*> path "A" <*> path "B"),
          entry "info" (say "list applications, words and defaults" "énumérer applications, mots et valeurs par défaut") ((`Command` Info) <$> settings),
          metavar (say "COMMAND" "COMMANDE")
        ]
    entry name what parser = command name (Options.info (helpOption <*> parser) (progDesc what <> failureCode 2))
    bareScene = rendering <$> renderOptions
    configured = (`Command` Configured) <$> settings

    rendering (s, make) = Command s (Render make)
    checking s f paths = Command s (Check f paths)
    comparing s a b = Command s (Compare a b)

    settings =
      Settings
        <$> optional (option language (long "language" <> metavar "en|fr" <> help (say "the language of messages" "la langue des messages")))
        <*> switch (long "quiet" <> short 'q' <> help (say "only the result, and what prevents it" "seulement le résultat, et ce qui l'empêche"))
        <*> optional (option (atLeast 1) (long "threads" <> metavar "N" <> help (say "use N processors (default: all)" "utiliser N processeurs (par défaut\xA0: tous)")))

    renderOptions = assemble <$> settings <*> scene <*> output <*> size "width" (say "W" "L") <*> size "height" "H" <*> sampling <*> crop <*> strict
    assemble s path' out w h n part isStrict = (s, \first -> Options path' (maybe (Numbered first) ToFile out) w h n part isStrict)
    output = optional (strOption (long "output" <> short 'o' <> metavar (say "FILE.png" "FICHIER.png") <> help (say "where the picture goes (default: NAME_NNN.png here, never over another)" "où va l'image (par défaut\xA0: NOM_NNN.png ici, jamais sur une autre)") <> action "file"))
    size name letter = optional (option (atLeast 1) (long name <> metavar letter <> help (say "instead of the scene's" "au lieu de celle de la scène")))
    sampling = optional (option (atLeast 1) (long "sampling" <> metavar "N" <> help (say "rays through each pixel" "rayons par pixel")))
    crop = optional (option fourNumbers (long "crop" <> metavar (say "X Y W H" "X Y L H") <> help (say "only this part: from column X, row Y" "seulement cette partie, depuis la colonne X, ligne Y")))
    fourNumbers = eitherReader $ \text -> case traverse (integer . Text.pack) (words text) of
      Right [x, y, w, h] -> Right (x, y, w, h)
      _ -> Left (say "four integers: column, row, width, height" "quatre entiers\xA0: colonne, ligne, largeur, hauteur")
    strict = switch (long "strict" <> help (say "draw nothing if the scene has faults" "ne rien dessiner si la scène a des fautes"))

    scene = path "SCENE"
    path name = strArgument (metavar name <> action "file")
    format = option (eitherReader formatNamed) (long "format" <> metavar "text|json" <> value AsText <> help (say "how to print (default: text)" "comment afficher (par défaut\xA0: text)"))
    formatNamed name = case name of
      "text" -> Right AsText
      "json" -> Right AsJson
      _ -> Left (say "text or json" "text ou json")
    language = eitherReader (\name -> maybe (Left "en, fr") Right (lookup (Text.toLower (Text.pack name)) languageNames))
    atLeast least = eitherReader $ \text -> case integer (Text.pack text) of
      Right n | n >= least -> Right n
      _ -> Left (say "an integer, at least " "un entier, au moins " <> show (least :: Int))
